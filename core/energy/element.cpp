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

// The derivatives by the corners are those by J through J = Σ_j u_j ∇φ_jᵀ: moving corner j by s
// changes J by s ∇φ_jᵀ. The ∇φ_j add up to zero, so those of corners 1 and 2 say all.

/// The blocks of corners 1 and 2 in the Hessian of a triangle.
class CornerBlocks {
 public:
  /// For every pair of corners: x_j y_kᵀ. The sum of what is added has to be symmetric.
  void add(const Mat2& x, const Mat2& y) {
    b11_ += x.col(0) * y.col(0).transpose();
    b12_ += x.col(0) * y.col(1).transpose();
    b22_ += x.col(1) * y.col(1).transpose();
  }
  /// ∇φ_j · ∇φ_k times I, and ∇φ_j × ∇φ_k times a quarter turn.
  void add(double of_identity, double of_determinant, const Mat2& gradients) {
    b11_.diagonal().array() += of_identity * gradients.col(0).squaredNorm();
    b12_.diagonal().array() += of_identity * gradients.col(0).dot(gradients.col(1));
    b22_.diagonal().array() += of_identity * gradients.col(1).squaredNorm();
    const double cross = of_determinant * determinant(gradients);
    b12_(0, 1) += cross;
    b12_(1, 0) -= cross;
  }

  Eigen::Matrix<double, 6, 6> of_all_corners() const {
    const Mat2 b01 = -(b11_ + b12_.transpose()), b02 = -(b12_ + b22_);
    Eigen::Matrix<double, 6, 6> all;
    all << -(b01 + b02), b01, b02,    //
        b01.transpose(), b11_, b12_,  //
        b02.transpose(), b12_.transpose(), b22_;
    return all;
  }

 private:
  Mat2 b11_ = Mat2::Zero(), b12_ = Mat2::Zero(), b22_ = Mat2::Zero();
};

Mat2 turned(const Mat2& vectors) {
  Mat2 result;
  result << -vectors.row(1), vectors.row(0);
  return result;
}

Eigen::Matrix<double, 6, 1> gradient_by_corners(const Mat2& gradients, const DensityDerivatives& d,
                                                const Mat2& J) {
  const Mat2 by_jacobian = d.norm * J + d.det * cofactors(J) + d.trace * Mat2::Identity();
  const Mat2 by_corners = by_jacobian * gradients;
  Eigen::Matrix<double, 6, 1> result;
  result << -by_corners.rowwise().sum(), by_corners.col(0), by_corners.col(1);
  return result;
}

void add_negative_curvature(const NegativeCurvature& c, double part, const Mat2& gradients,
                            CornerBlocks& blocks) {
  const Mat2 r = c.rotation * gradients, e = c.reflection * gradients;
  blocks.add(part * (c.of_rotation * r + c.of_both * e), r);
  blocks.add(part * (c.of_both * r + c.of_reflection * e), e);
  blocks.add(part * c.of_twist * turned(r), turned(r));
  blocks.add(part * c.of_flip * turned(e), turned(e));
}

Eigen::Matrix<double, 6, 6> hessian_by_corners(const Mat2& gradients, const DensityDerivatives& d,
                                               const Mat2& J, double clamping) {
  CornerBlocks blocks;
  const Mat2 j = J * gradients, g = cofactors(J) * gradients;
  blocks.add(d.norm_norm * j + d.norm_det * g, j);
  blocks.add(d.norm_det * j + d.det_det * g, g);
  blocks.add(d.norm, d.det, gradients);
  if (clamping > 0)
    if (const std::optional<NegativeCurvature> negative = negative_curvature(d, J))
      add_negative_curvature(*negative, clamping, gradients, blocks);
  return blocks.of_all_corners();
}

double distortion_weight(const EnergySettings& settings, const RestElement& rest) {
  return rest.stiffness * (settings.area_weighted ? rest.area : settings.unit_area);
}

double barrier_weight(const EnergySettings& settings, const RestElement& rest) {
  return settings.barrier_area_weighted ? settings.beta * rest.area : settings.beta;
}

void add(double weight, const DensityDerivatives& density, DensityDerivatives& sum) {
  sum.norm += weight * density.norm;
  sum.det += weight * density.det;
  sum.norm_norm += weight * density.norm_norm;
  sum.norm_det += weight * density.norm_det;
  sum.det_det += weight * density.det_det;
  sum.trace += weight * density.trace;
}

/// Derivatives of weight·ψ + β χ, and of the conformal term; the values go to `energy`.
DensityDerivatives weighted_derivatives(const EnergySettings& settings, const RestElement& rest,
                                        const Mat2& J, ElementEnergy& energy) {
  DensityDerivatives sum;
  const DensityDerivatives density = settings.density->derivatives(J);
  const double weight = distortion_weight(settings, rest);
  energy.distortion = weight * density.value;
  add(weight, density, sum);
  const BarrierDerivatives chi = barrier_derivatives(determinant(J), settings.delta);
  const double beta = barrier_weight(settings, rest);
  energy.barrier = beta * chi.value;
  sum.det += beta * chi.first;
  sum.det_det += beta * chi.second;
  if (settings.conformal_weight > 0) {
    const DensityDerivatives square = conformal_square_derivatives(J);
    energy.barrier += settings.conformal_weight * square.value;
    add(settings.conformal_weight, square, sum);
  }
  return sum;
}

}  // namespace

RestElement rest_element(const Corners& rest) {
  const double area = signed_area(rest.col(0), rest.col(1), rest.col(2));
  return {area, hat_gradients(rest.col(0), rest.col(1), rest.col(2), area)};
}

RestElement rest_element(const MeshPair& mesh, const Eigen::Vector3i& t) {
  const Corners corners = corners_of(mesh.rest(), t);
  RestElement rest = rest_element(corners);
  if (mesh.stiffness()) rest.stiffness = mesh.stiffness()->at(corners.rowwise().mean());
  return rest;
}

RestElement reference_element(const EnergySettings& settings, const RestElement& rest) {
  if (settings.reference == Reference::rest) return rest;
  const double side = std::sqrt(4 / std::sqrt(3.0) * rest.area);
  Corners equilateral;
  equilateral << 0, side, 0.5 * side,  //
      0, 0, 0.5 * std::sqrt(3.0) * side;
  RestElement reference = rest_element(equilateral);
  reference.stiffness = rest.stiffness;
  return reference;
}

RestElement reference_element(const EnergySettings& settings, const MeshPair& mesh,
                              const Eigen::Vector3i& t) {
  return reference_element(settings, rest_element(mesh, t));
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
  result.gradient = gradient_by_corners(rest.gradients.rightCols<2>(), d, J);
  return result;
}

ElementHessian element_hessian(const EnergySettings& settings, const RestElement& rest,
                               const Corners& deformed, double clamping) {
  ElementHessian result;
  const Mat2 J = deformation_gradient(rest, deformed);
  const Mat2 gradients = rest.gradients.rightCols<2>();
  const DensityDerivatives d = weighted_derivatives(settings, rest, J, result.energy);
  result.gradient = gradient_by_corners(gradients, d, J);
  result.hessian = hessian_by_corners(gradients, d, J, clamping);
  return result;
}

}  // namespace foldless
