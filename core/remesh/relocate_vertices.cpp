// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/relocate_vertices.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <vector>

#include "core/energy/moved_corner.h"
#include "core/remesh/diamond_energy.h"

namespace foldless {
namespace {

constexpr int kMostSweeps = 20;
/// Of the curvature along each coordinate, added to it: there is next to none along a move of both
/// meshes that leaves the map as it is. More of it where that leads too far.
constexpr double kLeastDamping = 1e-3, kMoreDamping = 8, kMostDamping = 1e4;
/// Of the way to where a triangle is used up.
constexpr double kPartOfTheWay = 0.8;
/// A step has to bring this part of what the slope promises.
constexpr double kPartOfTheSlope = 1e-4;
/// No triangle at rest becomes flatter than this, or than the flattest round the vertex was. The
/// map does not care, but a finer mesh cannot take over what is next to degenerate, nor does
/// anybody want to work with it. [relative height]
constexpr double kLeastHeight = 1e-3;

/// Triangles round a vertex, which is their corner 0.
using Star = std::vector<Eigen::Vector3i>;

Star star_of(const MeshPair& mesh, int v) {
  Star star;
  for (const int t : mesh.triangles_of_vertex(v)) {
    Eigen::Vector3i corners = mesh.triangles().col(t);
    while (corners[0] != v) corners = Eigen::Vector3i(corners[1], corners[2], corners[0]);
    star.push_back(corners);
  }
  return star;
}

MovedCorner moved_vertex(const MeshPair& mesh, const Star& star, const EnergySettings& energy) {
  MovedCorner sum;
  for (const Eigen::Vector3i& t : star) {
    const MovedCorner one =
        moved_corner(energy, reference_element(energy, mesh, t), corners_of(mesh.deformed(), t), 1);
    sum.energy += one.energy;
    sum.gradient += one.gradient;
    sum.hessian += one.hessian;
  }
  return sum;
}

/// How many times `move` leads to where the first triangle of the star is used up.
double way_to_first_used_up(const Points& points, const Star& star, const Vec2& move) {
  double first = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3i& t : star) {
    const double change = 0.5 * cross(points.col(t[2]) - points.col(t[1]), move);
    if (change < 0) first = std::min(first, -signed_area(points, t) / change);
  }
  return first;
}

/// Relative height at rest below which no triangle of the star may fall.
double height_to_keep(const MeshPair& mesh, const Star& star) {
  double least = kLeastHeight;
  for (const Eigen::Vector3i& t : star) least = std::min(least, relative_height_at_rest(mesh, t));
  return least;
}

bool is_proved_feasible(const MeshPair& mesh, const Star& star, double delta, double height) {
  return foldless::is_proved_feasible(mesh, star, delta) &&
         std::ranges::all_of(star, [&](const Eigen::Vector3i& t) {
           return relative_height_at_rest(mesh, t) >= height;
         });
}

/// Returns by how much the energy fell.
double relocate(MeshPair& mesh, int v, const EnergySettings& energy) {
  const Star star = star_of(mesh, v);
  const MovedCorner at = moved_vertex(mesh, star, energy);
  const Vec2 rest = mesh.rest().col(v), deformed = mesh.deformed().col(v);
  const double height = height_to_keep(mesh, star);
  for (double damping = kLeastDamping; damping < kMostDamping; damping *= kMoreDamping) {
    Eigen::Matrix4d damped = at.hessian;
    damped.diagonal() *= 1 + damping;
    const Eigen::Vector4d move = -damped.ldlt().solve(at.gradient);
    const double slope = at.gradient.dot(move);
    if (!(slope < 0)) break;
    mesh.move_vertex(v, rest, deformed);
    const double way = std::min(way_to_first_used_up(mesh.rest(), star, move.head<2>()),
                                way_to_first_used_up(mesh.deformed(), star, move.tail<2>()));
    const double step = std::min(1.0, kPartOfTheWay * way);
    mesh.move_vertex(v, rest + step * move.head<2>(), deformed + step * move.tail<2>());
    if (!is_proved_feasible(mesh, star, energy.delta, height)) continue;
    const double fall = at.energy - energy_of(mesh, star, energy);
    if (fall >= -kPartOfTheSlope * step * slope) return fall;
  }
  mesh.move_vertex(v, rest, deformed);
  return 0;
}

std::vector<int> movable_vertices(const MeshPair& mesh, int first) {
  std::vector<int> movable;
  for (int v = first; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v)) movable.push_back(v);
  return movable;
}

}  // namespace

double relocate_vertices(MeshPair& mesh, const RelocateSettings& settings,
                         const std::stop_token& token) {
  const std::vector<int> movable = movable_vertices(mesh, settings.first_movable);
  double fall = 0;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double gain = 0;
    for (const int v : movable) {
      if (token.stop_requested()) return fall + gain;
      gain += relocate(mesh, v, settings.energy);
    }
    fall += gain;
    if (gain <= settings.least_gain) break;
  }
  return fall;
}

}  // namespace foldless
