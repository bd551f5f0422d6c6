// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/boundary_guard.h"

#include <algorithm>
#include <limits>

#include "core/energy/quadratic.h"

namespace foldless {

BoundaryGuard::BoundaryGuard(const MeshPair& mesh)
    : gap_of_(static_cast<std::size_t>(mesh.vertex_count()), -1) {
  const std::vector<BoundaryNeighbours> neighbours =
      boundary_neighbours(mesh.triangles(), mesh.vertex_count());
  std::vector<bool> overlaps(neighbours.size(), false);
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

bool BoundaryGuard::stays_open(const Points& u, const Points& end) const {
  return std::ranges::none_of(gaps_, [&](const BoundaryGap& gap) {
    const GapSides before = sides_of(gap, u), after = sides_of(gap, end);
    const bool was_narrow =
        before.previous.dot(before.next) > 0 && cross(before.previous, before.next) > 0;
    return was_narrow && after.previous.dot(after.next) > 0 &&
           !(cross(after.previous, after.next) > 0);
  });
}

}  // namespace foldless
