// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/injective.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
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

/// Triangles that a thread takes together.
constexpr std::ptrdiff_t kGrain = 2048;

std::size_t place(int v) { return static_cast<std::size_t>(v); }

/// Whether the link edge of a corner of a counter-clockwise triangle crosses the horizontal ray to
/// the right of the corner upwards: it turns by less than π round the corner, so it does exactly
/// when it begins below and ends on or above. The sum round an interior vertex is its winding
/// number, found by comparisons alone.
bool crosses_ray(const Eigen::Vector3i& t, int corner, const Points& points) {
  const double y = points(1, t[corner]);
  return points(1, t[kNext[corner]]) < y && y <= points(1, t[kPrevious[corner]]);
}

}  // namespace

std::vector<bool> interior_vertices(const Triangles& triangles,
                                    const std::vector<BoundaryNeighbours>& boundary) {
  std::vector<bool> interior(boundary.size(), false);
  for (const int v : triangles.reshaped()) interior[place(v)] = !boundary[place(v)].are_there();
  return interior;
}

InjectivityChecker::InjectivityChecker(Triangles triangles, int vertex_count)
    : triangles_(std::move(triangles)),
      boundary_(boundary_neighbours(triangles_, vertex_count)),
      interior_(interior_vertices(triangles_, boundary_)),
      interior_count_(std::ranges::count(interior_, true)) {
  const auto is_at_boundary = [this](int v) { return boundary_[place(v)].are_there(); };
  for (int f = 0; f < triangles_.cols(); ++f)
    if (std::ranges::any_of(triangles_.col(f), is_at_boundary)) outer_triangles_.push_back(f);
}

InjectivityReport InjectivityChecker::check(const Points& points) const {
  assert(static_cast<std::size_t>(points.cols()) == interior_.size());
  return is_proved(points) ? InjectivityReport() : report_on(points);
}

// With counter-clockwise triangles an interior vertex is wound once or more, so all are wound once
// exactly where they are as many as the crossings.
bool InjectivityChecker::is_proved(const Points& points) const {
  std::atomic<bool> has_failed = false;
  std::atomic<std::ptrdiff_t> crossings = 0;
  in_ranges(std::ssize(outer_triangles_), kGrain, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::ptrdiff_t at_others = 0;
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      const Eigen::Vector3i t = triangles_.col(outer_triangles_[static_cast<std::size_t>(i)]);
      for (int corner = 0; corner < 3; ++corner)
        at_others += boundary_[place(t[corner])].are_there() && crosses_ray(t, corner, points);
      if (has_overlap(t, points, boundary_)) has_failed = true;
    }
    crossings -= at_others;
  });
  if (has_failed) return false;
  in_ranges(triangles_.cols(), kGrain, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::ptrdiff_t all = 0;
    for (std::ptrdiff_t f = begin; f < end; ++f) {
      const Eigen::Vector3i t = triangles_.col(f);
      if (orientation(points, t) <= 0) {
        has_failed = true;
        return;
      }
      for (int corner = 0; corner < 3; ++corner) all += crosses_ray(t, corner, points);
    }
    crossings += all;
  });
  return !has_failed && crossings == interior_count_;
}

InjectivityReport InjectivityChecker::report_on(const Points& points) const {
  InjectivityReport report;
  std::vector<int> crossings(interior_.size(), 0);
  std::vector<char> overlaps(interior_.size(), 0);
  std::vector<bool> positive(interior_.size(), true);
  for (int f = 0; f < triangles_.cols(); ++f) {
    const Eigen::Vector3i t = triangles_.col(f);
    const int sign = orientation(points, t);
    if (sign > 0) {
      for (int corner = 0; corner < 3; ++corner)
        crossings[place(t[corner])] += crosses_ray(t, corner, points);
      mark_overlaps(t, points, boundary_, overlaps);
      continue;
    }
    for (const int v : t) positive[place(v)] = false;
    if (sign < 0) count_offender(f, report.inverted, report.first_inverted);
    if (sign == 0) count_offender(f, report.degenerate, report.first_degenerate);
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
