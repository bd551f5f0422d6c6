// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/motion_proof.h"

#include "core/motion/moving_corner.h"

namespace foldless {

MotionProof::MotionProof(const Triangles& triangles, int vertex_count)
    : triangles_(triangles),
      checker_(triangles, vertex_count),
      boundary_(boundary_neighbours(triangles, vertex_count)) {}

std::optional<MotionFailure> MotionProof::failure_at_start(const Points& from) const {
  const InjectivityReport report = checker_.check(from);
  using Place = MotionFailure::Place;
  if (report.first_inverted) return MotionFailure{Place::triangle, *report.first_inverted, 0};
  if (report.first_degenerate) return MotionFailure{Place::triangle, *report.first_degenerate, 0};
  if (report.first_branch_vertex)
    return MotionFailure{Place::branch_vertex, *report.first_branch_vertex, 0};
  if (!report.overlapping_boundary_vertices.empty())
    return MotionFailure{Place::boundary_vertex, report.overlapping_boundary_vertices.front(), 0};
  return std::nullopt;
}

std::optional<MotionFailure> MotionProof::first_failure(const Points& from,
                                                        const Points& to) const {
  std::optional<MotionFailure> first = failure_at_start(from);
  if (first) return first;
  const auto point = [&](int v) { return MovingPoint{from.col(v), to.col(v)}; };
  const auto take = [&](MotionFailure::Place place, Eigen::Index index,
                        const std::optional<double>& moment) {
    if (moment && (!first || *moment < first->moment))
      first = MotionFailure{place, static_cast<int>(index), *moment};
  };
  for (Eigen::Index f = 0; f < triangles_.cols(); ++f) {
    const Eigen::Vector3i t = triangles_.col(f);
    take(MotionFailure::Place::triangle, f,
         first_flat_moment({point(t[0]), point(t[1]), point(t[2])}));
  }
  for (std::size_t v = 0; v < boundary_.size(); ++v) {
    const BoundaryNeighbours& n = boundary_[v];
    if (!n.are_there()) continue;
    take(MotionFailure::Place::boundary_vertex, static_cast<Eigen::Index>(v),
         first_closed_moment({point(static_cast<int>(v)), point(n.next), point(n.previous)}));
  }
  return first;
}

}  // namespace foldless
