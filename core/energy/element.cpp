// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element.h"

#include <cmath>
#include <limits>

#include "core/energy/barrier.h"
#include "core/energy/clamp.h"
#include "core/energy/conformal_square.h"
#include "core/energy/determinant.h"

namespace foldless {
namespace {

// The derivatives by the corners are those by vec(J) through J = Σ_j u_j ∇φ_jᵀ: the pair of rows
// of column c of J and the pair of rows of corner j are joined by ∂_c φ_j.

Eigen::Matrix<double, 6, 1> gradient_by_corners(const RestElement& rest,
                                                const Eigen::Vector4d& gradient) {
  Eigen::Matrix<double, 6, 1> result;
  for (int j = 0; j < 3; ++j)
    result.segment<2>(2 * j) =
        rest.gradients(0, j) * gradient.head<2>() + rest.gradients(1, j) * gradient.tail<2>();
  return result;
}

Eigen::Matrix<double, 6, 6> hessian_by_corners(const RestElement& rest,
                                               const Eigen::Matrix4d& hessian) {
  Eigen::Matrix<double, 6, 6> result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix<double, 4, 2> column = rest.gradients(0, k) * hessian.leftCols<2>() +
                                               rest.gradients(1, k) * hessian.rightCols<2>();
    for (int j = 0; j < 3; ++j)
      result.block<2, 2>(2 * j, 2 * k) = rest.gradients(0, j) * column.topRows<2>() +
                                         rest.gradients(1, j) * column.bottomRows<2>();
  }
  return result;
}

double distortion_weight(const EnergySettings& settings, const RestElement& rest) {
  return settings.area_weighted ? rest.area : 1;
}

double barrier_weight(const EnergySettings& settings, const RestElement& rest) {
  return settings.barrier_area_weighted ? settings.beta * rest.area : settings.beta;
}

/// Value and derivatives of weight·ψ + β χ with respect to vec(J).
DensityDerivatives weighted_derivatives(const EnergySettings& settings, const RestElement& rest,
                                        const Mat2& J, ElementEnergy& energy) {
  const double weight = distortion_weight(settings, rest);
  DensityDerivatives d = settings.density->derivatives(J);
  energy.distortion = weight * d.value;
  d.gradient *= weight;
  d.hessian *= weight;
  const BarrierDerivatives chi = barrier_derivatives(determinant(J), settings.delta);
  const double beta = barrier_weight(settings, rest);
  energy.barrier = beta * chi.value;
  if (chi.value > 0) {
    const Eigen::Vector4d g = determinant_gradient(J);
    d.gradient += beta * chi.first * g;
    d.hessian += beta * (chi.second * g * g.transpose() + chi.first * determinant_hessian());
  }
  if (settings.conformal_weight > 0) {
    const DensityDerivatives square = conformal_square_derivatives(J);
    energy.barrier += settings.conformal_weight * square.value;
    d.gradient += settings.conformal_weight * square.gradient;
    d.hessian += settings.conformal_weight * square.hessian;
  }
  return d;
}

}  // namespace

RestElement rest_element(const Corners& rest) {
  const double area = signed_area(rest.col(0), rest.col(1), rest.col(2));
  return {area, hat_gradients(rest.col(0), rest.col(1), rest.col(2), area)};
}

RestElement rest_element(const EnergySettings& settings, const Corners& rest) {
  if (settings.reference == Reference::rest) return rest_element(rest);
  const double area = signed_area(rest.col(0), rest.col(1), rest.col(2));
  const double side = std::sqrt(4 / std::sqrt(3.0) * area);
  Corners equilateral;
  equilateral << 0, side, 0.5 * side,  //
      0, 0, 0.5 * std::sqrt(3.0) * side;
  return rest_element(equilateral);
}

Mat2 deformation_gradient(const RestElement& rest, const Corners& deformed) {
  // The hat gradients add up to zero, so edge vectors do: no cancellation far from the origin.
  return (deformed.col(1) - deformed.col(0)) * rest.gradients.col(1).transpose() +
         (deformed.col(2) - deformed.col(0)) * rest.gradients.col(2).transpose();
}

ElementEnergy element_energy(const EnergySettings& settings, const RestElement& rest,
                             const Corners& deformed) {
  const Mat2 J = deformation_gradient(rest, deformed);
  const double chi = barrier_value(determinant(J), settings.delta);
  constexpr double kOutside = std::numeric_limits<double>::infinity();
  // The bound A′ > δA holds for β = 0 too, where 0 · ∞ would hide it.
  if (chi == kOutside) return {0, kOutside};
  double barrier = barrier_weight(settings, rest) * chi;
  if (settings.conformal_weight > 0)
    barrier += settings.conformal_weight * conformal_square_value(J);
  return {distortion_weight(settings, rest) * settings.density->value(J), barrier};
}

ElementGradient element_gradient(const EnergySettings& settings, const RestElement& rest,
                                 const Corners& deformed) {
  ElementGradient result;
  const Mat2 J = deformation_gradient(rest, deformed);
  const DensityDerivatives d = weighted_derivatives(settings, rest, J, result.energy);
  result.gradient = gradient_by_corners(rest, d.gradient);
  return result;
}

ElementHessian element_hessian(const EnergySettings& settings, const RestElement& rest,
                               const Corners& deformed, double clamping) {
  ElementHessian result;
  const Mat2 J = deformation_gradient(rest, deformed);
  DensityDerivatives d = weighted_derivatives(settings, rest, J, result.energy);
  if (clamping > 0) d.hessian = clamped_hessian(d.hessian, J, clamping);
  result.gradient = gradient_by_corners(rest, d.gradient);
  result.hessian = hessian_by_corners(rest, d.hessian);
  return result;
}

}  // namespace foldless
