// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/diamond_energy.h"

#include <algorithm>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

double longest_edge_squared(const MeshPair& mesh, const Eigen::Vector3i& t) {
  const Corners rest = corners_of(mesh.rest(), t);
  return std::max({(rest.col(1) - rest.col(0)).squaredNorm(),
                   (rest.col(2) - rest.col(1)).squaredNorm(),
                   (rest.col(0) - rest.col(2)).squaredNorm()});
}

bool is_positive_at_rest(const MeshPair& mesh, const Eigen::Vector3i& t, double area) {
  return 2 * area > kLeastRelativeHeight * longest_edge_squared(mesh, t);
}

}  // namespace

TrianglePair triangles_of(const Diamond& diamond) {
  const auto& [a, b, c, d, left, right] = diamond;
  return {Eigen::Vector3i(a, b, c), Eigen::Vector3i(b, a, d)};
}

TrianglePair flipped_triangles_of(const Diamond& diamond) {
  const auto& [a, b, c, d, left, right] = diamond;
  return {Eigen::Vector3i(a, d, c), Eigen::Vector3i(d, b, c)};
}

double relative_height_at_rest(const MeshPair& mesh, const Eigen::Vector3i& triangle) {
  return 2 * signed_area(mesh.rest(), triangle) / longest_edge_squared(mesh, triangle);
}

bool is_positive_at_rest(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles) {
  return std::ranges::all_of(triangles, [&](const Eigen::Vector3i& t) {
    return is_positive_at_rest(mesh, t, signed_area(mesh.rest(), t));
  });
}

bool is_feasible(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles, double delta) {
  return std::ranges::all_of(triangles, [&](const Eigen::Vector3i& t) {
    const double area = signed_area(mesh.rest(), t);
    return signed_area(mesh.deformed(), t) > delta * area && is_positive_at_rest(mesh, t, area);
  });
}

bool is_proved_feasible(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles,
                        double delta) {
  return is_feasible(mesh, triangles, delta) &&
         std::ranges::all_of(triangles, [&](const Eigen::Vector3i& t) {
           return orientation(mesh.rest(), t) > 0 && orientation(mesh.deformed(), t) > 0;
         });
}

double energy_of(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles,
                 const EnergySettings& settings) {
  double sum = 0;
  for (const Eigen::Vector3i& t : triangles)
    sum += element_energy(settings, reference_element(settings, mesh, t),
                          corners_of(mesh.deformed(), t))
               .total();
  return sum;
}

double condition_of(const MeshPair& mesh, const TrianglePair& triangles, const Diamond& diamond,
                    const EnergySettings& settings) {
  const std::array<int, 4> vertices{diamond.a, diamond.b, diamond.c, diamond.d};
  Eigen::Matrix<double, 2, 4> gradient = Eigen::Matrix<double, 2, 4>::Zero();
  double energy = 0;
  for (const Eigen::Vector3i& t : triangles) {
    const ElementGradient e = element_gradient(settings, reference_element(settings, mesh, t),
                                               corners_of(mesh.deformed(), t));
    energy += e.energy.total();
    for (int corner = 0; corner < 3; ++corner) {
      const auto place = std::ranges::find(vertices, t[corner]) - vertices.begin();
      gradient.col(place) += e.gradient.segment<2>(2 * corner);
    }
  }
  return energy > 0 ? gradient.cwiseAbs().maxCoeff() / energy : 0;
}

}  // namespace foldless
