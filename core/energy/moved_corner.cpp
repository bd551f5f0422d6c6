// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/moved_corner.h"

#include "core/energy/conformal_power.h"

namespace foldless {

MovedCorner moved_corner(const EnergySettings& settings, const RestElement& rest,
                         const Corners& deformed, double clamping) {
  const ElementHessian element = element_hessian(settings, rest, deformed, clamping);
  const Mat2 J = deformation_gradient(rest, deformed);
  double conformal = 0;
  if (settings.conformal_weight > 0)
    conformal = settings.conformal_weight * conformal_power_value(J, settings.conformal_power);
  double weighted_by_area = 0;
  if (settings.area_weighted) weighted_by_area += element.energy.distortion;
  if (settings.barrier_area_weighted) weighted_by_area += element.energy.barrier - conformal;

  // What moves at rest by s and deformed by x is, as the map sees it, deformed by x − J s.
  Eigen::Matrix<double, 2, 4> as_deformed;
  as_deformed << -J, Mat2::Identity();
  MovedCorner moved;
  moved.energy = element.energy.total();
  moved.gradient = as_deformed.transpose() * element.gradient.head<2>();
  moved.gradient.head<2>() += weighted_by_area * rest.gradients.col(0);
  moved.hessian = as_deformed.transpose() * element.hessian.topLeftCorner<2, 2>() * as_deformed;
  return moved;
}

}  // namespace foldless
