// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/element.h"

#include <cmath>

#include "core/energy/density_kinds.h"
#include "core/energy/element_formulas.h"

namespace foldless {
namespace {

ElementOf<double> element_of(const RestElement& rest, const Corners& deformed) {
  const Vec2 first = deformed.col(1) - deformed.col(0), second = deformed.col(2) - deformed.col(0);
  return {rest.area,
          rest.stiffness,
          matrix2(rest.gradients.rightCols<2>()),
          {first.x(), first.y(), second.x(), second.y()}};
}

Eigen::Matrix<double, 6, 1> of_all_corners(const Matrix2<double>& gradients) {
  Eigen::Matrix<double, 6, 1> all;
  for (int corner = 0; corner < 3; ++corner)
    all.segment<2>(2 * corner) = gradient_of_corner(gradients, corner);
  return all;
}

Eigen::Matrix<double, 6, 6> of_all_corners(const BlocksOf<double>& blocks) {
  Eigen::Matrix<double, 6, 6> all;
  for (int corner = 0; corner < 3; ++corner)
    all.middleCols<2>(2 * corner) = columns_of_corner(blocks, corner);
  return all;
}

FirstOrder<double> first_order_of(const EnergySettings& settings,
                                  const ElementOf<double>& element) {
  return with_density(settings.density->kind, [&](auto density) {
    return first_order_of<decltype(density)>(settings, element);
  });
}

}  // namespace

RestElement rest_element(const Corners& rest) {
  const double area = signed_area(rest.col(0), rest.col(1), rest.col(2));
  return {area, hat_gradients(rest.col(0), rest.col(1), rest.col(2), area), 1};
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
  const ElementOf<double> element = element_of(rest, deformed);
  return with_density(settings.density->kind, [&](auto density) -> ElementEnergy {
    const auto [distortion, barrier] = energy_of<decltype(density)>(settings, element);
    return {distortion, barrier};
  });
}

ElementGradient element_gradient(const EnergySettings& settings, const RestElement& rest,
                                 const Corners& deformed) {
  const FirstOrder<double> at = first_order_of(settings, element_of(rest, deformed));
  return {{at.energy.distortion, at.energy.barrier}, of_all_corners(at.gradient)};
}

ElementHessian element_hessian(const EnergySettings& settings, const RestElement& rest,
                               const Corners& deformed, double clamping) {
  const ElementOf<double> element = element_of(rest, deformed);
  const FirstOrder<double> at = first_order_of(settings, element);
  return {{at.energy.distortion, at.energy.barrier},
          of_all_corners(at.gradient),
          of_all_corners(hessian_by_corners(at, element.gradients, clamping))};
}

}  // namespace foldless
