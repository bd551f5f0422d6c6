// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/energy/barrier.h"
#include "core/energy/clamp.h"
#include "core/energy/conformal_power.h"
#include "core/energy/corner_blocks.h"
#include "core/energy/energy_settings.h"

// Energies of a triangle and their derivatives by the corners, of one triangle or of several at
// once. Derivatives by the corners are those by J through J = Σ_j u_j ∇φ_jᵀ: moving corner j by s
// changes J by s ∇φ_jᵀ. The ∇φ_j add up to zero, so those of corners 1 and 2 say all.

namespace foldless {

/// A triangle with what its energy depends on.
template <class Real>
struct ElementOf {
  Real area;                ///< at rest
  Real stiffness;           ///< factor on the distortion
  Matrix2<Real> gradients;  ///< ∇φ₁ and ∇φ₂
  Matrix2<Real> edges;      ///< from the deformed corner 0 to corners 1 and 2
};

/// Distortion and barrier, weights included; see ElementEnergy.
template <class Real>
struct EnergyOf {
  Real distortion, barrier;
};

/// J, from edge vectors: no cancellation far from the origin.
template <class Real>
FOLDLESS_INLINED Matrix2<Real> deformation_gradient(const ElementOf<Real>& element) {
  return element.edges * transposed(element.gradients);
}

template <class Real>
FOLDLESS_INLINED Real distortion_weight(const EnergySettings& settings,
                                        const ElementOf<Real>& element) {
  return element.stiffness * (settings.area_weighted ? element.area : Real(settings.unit_area));
}

template <class Real>
FOLDLESS_INLINED Real barrier_weight(const EnergySettings& settings,
                                     const ElementOf<Real>& element) {
  return settings.barrier_area_weighted ? settings.beta * element.area : Real(settings.beta);
}

template <class Real>
FOLDLESS_INLINED void add(const Real& weight, const DerivativesOf<Real>& density,
                          DerivativesOf<Real>& sum) {
  sum.norm += weight * density.norm;
  sum.det += weight * density.det;
  sum.norm_norm += weight * density.norm_norm;
  sum.norm_det += weight * density.norm_det;
  sum.det_det += weight * density.det_det;
  sum.trace += weight * density.trace;
}

template <class Kind, class Real>
FOLDLESS_INLINED EnergyOf<Real> energy_of(const EnergySettings& settings,
                                          const ElementOf<Real>& element) {
  constexpr double kOutside = std::numeric_limits<double>::infinity();
  const Matrix2<Real> J = deformation_gradient(element);
  const Real chi = barrier_value(determinant(J), settings.delta);
  Real barrier = barrier_weight(settings, element) * chi;
  if (settings.conformal_weight > 0)
    barrier += settings.conformal_weight * ConformalPower::value(J, settings.conformal_power);
  // The bound A′ > δA holds for β = 0 too, where 0 · ∞ would hide it.
  const auto is_outside = chi == kOutside;
  return {select(is_outside, 0, distortion_weight(settings, element) * Kind::value(J)),
          select(is_outside, kOutside, barrier)};
}

/// Derivatives of weight·ψ + β χ, and of the conformal term; the values go to `energy`.
template <class Kind, class Real>
FOLDLESS_INLINED DerivativesOf<Real> weighted_derivatives(const EnergySettings& settings,
                                                          const ElementOf<Real>& element,
                                                          const Matrix2<Real>& J,
                                                          EnergyOf<Real>& energy) {
  DerivativesOf<Real> sum;
  const DerivativesOf<Real> density = Kind::derivatives(J);
  const Real weight = distortion_weight(settings, element);
  energy.distortion = weight * density.value;
  add(weight, density, sum);
  const BarrierDerivatives<Real> chi = barrier_derivatives(determinant(J), settings.delta);
  const Real beta = barrier_weight(settings, element);
  energy.barrier = beta * chi.value;
  sum.det += beta * chi.first;
  sum.det_det += beta * chi.second;
  if (settings.conformal_weight > 0) {
    const DerivativesOf<Real> conformal = ConformalPower::derivatives(J, settings.conformal_power);
    energy.barrier += settings.conformal_weight * conformal.value;
    add(Real(settings.conformal_weight), conformal, sum);
  }
  return sum;
}

/// Of corners 1 and 2, one a column.
template <class Real>
FOLDLESS_INLINED Matrix2<Real> gradient_by_corners(const DerivativesOf<Real>& d,
                                                   const Matrix2<Real>& J,
                                                   const Matrix2<Real>& gradients) {
  const Matrix2<Real> by_jacobian =
      d.norm * J + d.det * cofactors(J) + Matrix2<Real>{d.trace, 0, 0, d.trace};
  return by_jacobian * gradients;
}

/// E of a triangle with what its derivatives by the corners are made of.
template <class Real>
struct FirstOrder {
  Matrix2<Real> J;
  EnergyOf<Real> energy;
  DerivativesOf<Real> by_jacobian;
  Matrix2<Real> gradient;  ///< by corners 1 and 2, one a column
};

template <class Kind, class Real>
FOLDLESS_INLINED FirstOrder<Real> first_order_of(const EnergySettings& settings,
                                                 const ElementOf<Real>& element) {
  FirstOrder<Real> result;
  result.J = deformation_gradient(element);
  result.by_jacobian = weighted_derivatives<Kind>(settings, element, result.J, result.energy);
  result.gradient = gradient_by_corners(result.by_jacobian, result.J, element.gradients);
  return result;
}

template <class Real>
FOLDLESS_INLINED void add_negative_curvature(const NegativeCurvature<Real>& c, const Real& part,
                                             const Matrix2<Real>& gradients,
                                             BlocksOf<Real>& blocks) {
  const Matrix2<Real> r = c.rotation * gradients, e = c.reflection * gradients;
  blocks.add(part * (c.of_rotation * r + c.of_both * e), r);
  blocks.add(part * (c.of_both * r + c.of_reflection * e), e);
  blocks.add(part * c.of_twist * turned(r), turned(r));
  blocks.add(part * c.of_flip * turned(e), turned(e));
}

/// Without the part `clamping` of the negative curvature.
template <class Real>
FOLDLESS_INLINED BlocksOf<Real> hessian_by_corners(const FirstOrder<Real>& at,
                                                   const Matrix2<Real>& gradients,
                                                   double clamping) {
  const auto& d = at.by_jacobian;
  const auto& J = at.J;
  const Matrix2<Real> zero{0, 0, 0, 0};
  BlocksOf<Real> blocks{zero, zero, zero};
  const Matrix2<Real> j = J * gradients, g = cofactors(J) * gradients;
  blocks.add(d.norm_norm * j + d.norm_det * g, j);
  blocks.add(d.norm_det * j + d.det_det * g, g);
  blocks.add(d.norm, d.det, gradients);
  if (clamping > 0) {
    const Curvature<Real> curvature(d, J);
    const auto is_positive = curvature.is_positive();
    if (!is_all(is_positive))
      add_negative_curvature(curvature.negative_part(), select(is_positive, 0, Real(clamping)),
                             gradients, blocks);
  }
  return blocks;
}

}  // namespace foldless
