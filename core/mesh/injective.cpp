// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/injective.h"

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/mesh/orientation.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

constexpr int kNext[] = {1, 2, 0};
constexpr int kPrevious[] = {2, 0, 1};

void count_offender(int index, int& count, std::optional<int>& first) {
  ++count;
  if (!first) first = index;
}

/// How often the link of each vertex crosses the horizontal ray to its right upwards, from the
/// corners of counter-clockwise triangles: round such a corner the link edge turns by less than
/// π, so it crosses the ray exactly when it begins below and ends on or above. For an interior
/// vertex the sum is its winding number, found by comparisons alone.
void count_crossings(const Eigen::Vector3i& t, const Points& points, std::vector<int>& crossings,
                     bool is_shared) {
  for (int corner = 0; corner < 3; ++corner) {
    const double y = points(1, t[corner]);
    if (!(points(1, t[kNext[corner]]) < y && y <= points(1, t[kPrevious[corner]]))) continue;
    int& count = crossings[static_cast<std::size_t>(t[corner])];
    if (is_shared)
      std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
    else
      ++count;
  }
}

}  // namespace

std::vector<bool> interior_vertices(const Triangles& triangles, int vertex_count) {
  // The link of a vertex is one chain of edges: the differences of their indices add up to zero
  // exactly when the chain is closed.
  const auto n = static_cast<std::size_t>(vertex_count);
  std::vector<std::int64_t> link(n, 0);
  std::vector<bool> interior(n, false);
  for (const auto& t : triangles.colwise())
    for (int corner = 0; corner < 3; ++corner) {
      const auto v = static_cast<std::size_t>(t[corner]);
      link[v] += t[kPrevious[corner]] - t[kNext[corner]];
      interior[v] = true;
    }
  for (std::size_t v = 0; v < n; ++v) interior[v] = interior[v] && link[v] == 0;
  return interior;
}

InjectivityChecker::InjectivityChecker(Triangles triangles, int vertex_count)
    : triangles_(std::move(triangles)),
      interior_(interior_vertices(triangles_, vertex_count)),
      boundary_(boundary_neighbours(triangles_, vertex_count)) {}

InjectivityReport InjectivityChecker::check(const Points& points) const {
  assert(static_cast<std::size_t>(points.cols()) == interior_.size());
  std::atomic<bool> are_all_positive = true;
  std::vector<int> crossings(interior_.size(), 0);
  std::vector<char> overlaps(interior_.size(), 0);
  constexpr std::ptrdiff_t kTogether = 2048;
  const bool is_shared = present_team() && triangles_.cols() > kTogether;
  each_in_ranges(triangles_.cols(), kTogether, [&](std::ptrdiff_t f) {
    const Eigen::Vector3i t = triangles_.col(f);
    if (orientation(points, t) <= 0)
      return are_all_positive.store(false, std::memory_order_relaxed);
    count_crossings(t, points, crossings, is_shared);
    mark_overlaps(t, points, boundary_, overlaps);
  });
  InjectivityReport report;
  std::vector<bool> positive(interior_.size(), true);
  for (Eigen::Index f = 0; !are_all_positive && f < triangles_.cols(); ++f) {
    const int sign = orientation(points, triangles_.col(f));
    if (sign > 0) continue;
    for (const int v : triangles_.col(f)) positive[static_cast<std::size_t>(v)] = false;
    if (sign < 0) count_offender(static_cast<int>(f), report.inverted, report.first_inverted);
    if (sign == 0) count_offender(static_cast<int>(f), report.degenerate, report.first_degenerate);
  }
  for (std::size_t v = 0; v < interior_.size(); ++v) {
    if (!positive[v]) continue;
    if (interior_[v] && crossings[v] != 1)
      count_offender(static_cast<int>(v), report.branch_vertices, report.first_branch_vertex);
    if (overlaps[v]) report.overlapping_boundary_vertices.push_back(static_cast<int>(v));
  }
  return report;
}

InjectivityReport check_injectivity(const Triangles& triangles, const Points& points) {
  return InjectivityChecker(triangles, static_cast<int>(points.cols())).check(points);
}

bool is_injective(const Triangles& triangles, const Points& points) {
  return check_injectivity(triangles, points).is_injective();
}

bool is_injective(const Triangles& triangles, const Points& rest, const Points& deformed) {
  const InjectivityChecker checker(triangles, static_cast<int>(rest.cols()));
  return checker.is_injective(rest) && checker.is_injective(deformed);
}

bool is_injective_inside(const Triangles& triangles, const Points& rest, const Points& deformed) {
  const InjectivityChecker checker(triangles, static_cast<int>(rest.cols()));
  return checker.is_injective_inside(rest) && checker.is_injective_inside(deformed);
}

std::vector<int> overlapping_boundary_vertices(const Triangles& triangles, const Points& points) {
  return check_injectivity(triangles, points).overlapping_boundary_vertices;
}

}  // namespace foldless
