// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/boundary_guard.h"

#include <algorithm>
#include <limits>

#include "core/energy/quadratic.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Of a gap at the end of a step: narrower ones would close by the rounding of what comes next,
/// the middles of edges that are split among it.
constexpr double kLeastTangent = 1e-9;

}  // namespace

BoundaryGuard::BoundaryGuard(const MeshPair& mesh)
    : gap_of_(static_cast<std::size_t>(mesh.vertex_count()), -1) {
  const std::vector<BoundaryNeighbours> neighbours =
      boundary_neighbours(mesh.triangles(), mesh.vertex_count());
  std::vector<char> overlaps(neighbours.size(), 0);
  for (const auto& t : mesh.triangles().colwise())
    for (const Points* points : {&mesh.rest(), &mesh.deformed()})
      mark_overlaps(t, *points, neighbours, overlaps);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (!neighbours[i].are_there() || overlaps[i]) continue;
    BoundaryGap gap{v, neighbours[i]};
    gap.width = angle_between(sides_of(gap, mesh.rest()));
    gap_of_[i] = static_cast<int>(gaps_.size());
    gaps_.push_back(gap);
  }
}

void BoundaryGuard::follow_flips(const Triangles& triangles, std::span<const RestElement> rest) {
  for (BoundaryGap& gap : gaps_) gap.area = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (const int v : triangles.col(t)) {
      const int gap = gap_of_[static_cast<std::size_t>(v)];
      if (gap >= 0)
        gaps_[static_cast<std::size_t>(gap)].area += rest[static_cast<std::size_t>(t)].area / 3;
    }
}

double BoundaryGuard::value(const Points& u) const {
  double sum = 0;
  for (const BoundaryGap& gap : gaps_) sum += gap_barrier_value(gap, u);
  return sum;
}

double BoundaryGuard::add_gradient(double weight, const Points& u,
                                   Eigen::VectorXd& gradient) const {
  double sum = 0;
  for (const BoundaryGap& gap : gaps_) {
    const GapBarrier barrier = gap_barrier(gap, u);
    if (barrier.value == 0) continue;
    sum += barrier.value;
    const auto& [next, previous] = gap.neighbours;
    gradient.segment<2>(2 * next) += weight * barrier.by_next;
    gradient.segment<2>(2 * previous) += weight * barrier.by_previous;
    gradient.segment<2>(2 * gap.vertex) -= weight * (barrier.by_next + barrier.by_previous);
  }
  return sum;
}

std::vector<GapSide> BoundaryGuard::curved_sides(const Points& u) const {
  std::vector<GapSide> sides;
  for (const BoundaryGap& gap : gaps_) {
    const GapBarrier barrier = gap_barrier(gap, u);
    if (barrier.value == 0) continue;
    sides.push_back({gap.vertex, gap.neighbours.next, barrier.next_curvature});
    sides.push_back({gap.vertex, gap.neighbours.previous, barrier.previous_curvature});
  }
  return sides;
}

// A gap that closes has its sides on one line and in one direction. It may open past half a turn
// and close from the other side only through a triangle that folds, which has a bound of its own.
double BoundaryGuard::largest_step(const Points& u, const Points& step) const {
  double largest = std::numeric_limits<double>::infinity();
  for (const BoundaryGap& gap : gaps_) {
    const GapSides x = sides_of(gap, u), s = sides_of(gap, step);
    const auto is_closed = [&](double t) {
      return (x.previous + t * s.previous).dot(x.next + t * s.next) > 0;
    };
    const double a = cross(s.previous, s.next), c = cross(x.previous, x.next);
    const double b = cross(x.previous, s.next) + cross(s.previous, x.next);
    for (const double t : roots(a, b, c))
      if (t > 0 && t < largest && is_closed(t)) largest = t;
  }
  return largest;
}

// A step from u ends with gaps above the floor; those that were below it already, as between the
// banks of a cut at rest, are open exactly.
bool BoundaryGuard::stays_open(const Points& u, const Points& end) const {
  const auto is_below_floor = [](const GapSides& sides) {
    const double along = sides.previous.dot(sides.next);
    return along > 0 && !(cross(sides.previous, sides.next) > kLeastTangent * along);
  };
  const auto is_open = [](const BoundaryGap& gap, const Points& points) {
    const auto& [next, previous] = gap.neighbours;
    return orientation(points.col(gap.vertex), points.col(previous), points.col(next)) > 0;
  };
  return std::ranges::none_of(gaps_, [&](const BoundaryGap& gap) {
    if (!is_below_floor(sides_of(gap, end))) return false;
    const GapSides before = sides_of(gap, u);
    if (!(before.previous.dot(before.next) > 0)) return false;  // as largest_step() has it
    return !is_below_floor(before) || (is_open(gap, u) && !is_open(gap, end));
  });
}

}  // namespace foldless
