// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/collapse_edges.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/remesh/diamond_energy.h"

namespace foldless {
namespace {

/// Height over length from which the rest boundary counts as bent: more than rounding makes of a
/// point on an edge.
constexpr double kBent = 1e-12;

/// Triangles as corners alone, with the triangles of every vertex at hand.
class Rings {
 public:
  Rings(const Triangles& triangles, int vertex_count)
      : ring_(static_cast<std::size_t>(vertex_count)) {
    for (const auto& t : triangles.colwise()) {
      for (const int v : t) of(v).push_back(static_cast<int>(triangles_.size()));
      triangles_.emplace_back(t);
    }
  }

  const std::vector<int>& of(int v) const { return ring_[static_cast<std::size_t>(v)]; }
  const Eigen::Vector3i& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  std::vector<Eigen::Vector3i> triangles_round(int v) const {
    std::vector<Eigen::Vector3i> triangles;
    for (const int t : of(v)) triangles.push_back(triangle(t));
    return triangles;
  }
  /// Each once, in ascending order.
  std::vector<int> neighbours(int v) const {
    std::vector<int> result;
    for (const int t : of(v))
      for (const int other : triangle(t))
        if (other != v) result.push_back(other);
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
  int triangles_beside(int a, int b) const {
    return static_cast<int>(
        std::ranges::count_if(of(a), [&](int t) { return (triangle(t).array() == b).any(); }));
  }
  /// The neighbours along the boundary; empty inside.
  std::vector<int> boundary_neighbours(int v) const {
    std::vector<int> result = neighbours(v);
    std::erase_if(result, [&](int other) { return triangles_beside(v, other) != 1; });
    return result;
  }

  /// Moves v's corners to `to`; triangles that have both go.
  void collapse(int v, int to) {
    for (const int t : std::exchange(of(v), {})) {
      Eigen::Vector3i& corners = triangles_[static_cast<std::size_t>(t)];
      if ((corners.array() == to).any()) {
        for (const int other : corners) std::erase(of(other), t);
        corners.setConstant(-1);
        continue;
      }
      std::ranges::replace(corners, v, to);
      of(to).push_back(t);
    }
  }

  /// What is left, with the vertices renumbered.
  Triangles triangles(const std::vector<int>& new_index) const {
    Triangles result(3, static_cast<Eigen::Index>(triangles_.size()));
    Eigen::Index count = 0;
    for (const Eigen::Vector3i& t : triangles_)
      if (t[0] >= 0)
        result.col(count++) =
            t.unaryExpr([&](int v) { return new_index[static_cast<std::size_t>(v)]; });
    return result.leftCols(count);
  }

 private:
  std::vector<int>& of(int v) { return ring_[static_cast<std::size_t>(v)]; }

  std::vector<std::vector<int>> ring_;
  std::vector<Eigen::Vector3i> triangles_;  ///< a −1 where it is gone
};

/// The removal of a vertex.
struct Collapse {
  int vertex;
  int to;       ///< the neighbour that takes its place
  double rise;  ///< of E
};

double conformal_distortion(const MeshPair& mesh, const Eigen::Vector3i& t) {
  const double sigma1 =
      signed_singular_values(deformation_gradient(mesh.rest(), mesh.deformed(), t))[0];
  return sigma1 * sigma1 * signed_area(mesh.rest(), t) / signed_area(mesh.deformed(), t);
}

double largest_distortion(const MeshPair& mesh, const std::vector<Eigen::Vector3i>& triangles) {
  double largest = 1;
  for (const Eigen::Vector3i& t : triangles)
    largest = std::max(largest, conformal_distortion(mesh, t));
  return largest;
}

bool is_straight(const Points& rest, int v, const std::vector<int>& along) {
  const Vec2 a = rest.col(along[0]), b = rest.col(along[1]);
  return std::abs(2 * signed_area(a, rest.col(v), b)) <= kBent * (b - a).squaredNorm() &&
         (a - rest.col(v)).dot(b - rest.col(v)) < 0;
}

/// Where a vertex may go by topology and outline: with the link condition, a boundary vertex along
/// the boundary.
std::vector<int> places_to_go(const MeshPair& mesh, const Rings& rings, int v) {
  const std::vector<int> along = rings.boundary_neighbours(v);
  if (!along.empty() && (along.size() != 2 || !is_straight(mesh.rest(), v, along))) return {};
  const std::vector<int> neighbours = rings.neighbours(v);
  std::vector<int> places;
  for (const int to : along.empty() ? neighbours : along) {
    std::vector<int> common;
    std::ranges::set_intersection(neighbours, rings.neighbours(to), std::back_inserter(common));
    if (static_cast<int>(common.size()) == rings.triangles_beside(v, to)) places.push_back(to);
  }
  return places;
}

std::vector<Eigen::Vector3i> triangles_after(const Rings& rings, int v, int to) {
  std::vector<Eigen::Vector3i> triangles = rings.triangles_round(v);
  std::erase_if(triangles, [&](const auto& t) { return (t.array() == to).any(); });
  for (Eigen::Vector3i& t : triangles) std::ranges::replace(t, v, to);
  return triangles;
}

// Positive triangles are enough for the angles of all vertices but two. Those round an interior
// vertex fill the simple polygon of its link, and so must the new ones, once. A corner of the link
// has at most two of the new triangles: their angles add up to what was there but for full turns,
// and to less than one. Only the neighbours of a boundary vertex along the boundary have a new
// neighbour there.
bool is_valid(const MeshPair& mesh, const std::vector<Eigen::Vector3i>& triangles, double delta) {
  return !triangles.empty() && is_proved_feasible(mesh, triangles, delta);
}

/// Whether a boundary vertex overlaps itself, in either mesh, when v has gone to `to`.
bool overlaps_after(const MeshPair& mesh, const Rings& rings, int v,
                    const std::vector<Eigen::Vector3i>& moved) {
  const auto overlaps = [&](int neighbour) {
    std::vector<Eigen::Vector3i> fan = rings.triangles_round(neighbour);
    std::erase_if(fan, [&](const auto& t) { return (t.array() == v).any(); });
    for (const Eigen::Vector3i& t : moved)
      if ((t.array() == neighbour).any()) fan.push_back(t);
    return overlaps_itself(neighbour, fan, mesh.rest()) ||
           overlaps_itself(neighbour, fan, mesh.deformed());
  };
  return std::ranges::any_of(rings.boundary_neighbours(v), overlaps);
}

std::optional<Collapse> best_collapse(const MeshPair& mesh, const Rings& rings, int v,
                                      const CollapseSettings& settings) {
  const std::vector<Eigen::Vector3i> before = rings.triangles_round(v);
  const double energy = energy_of(mesh, before, settings.energy);
  const double bound = std::max(settings.largest_distortion, largest_distortion(mesh, before));
  std::optional<Collapse> best;
  for (const int to : places_to_go(mesh, rings, v)) {
    const std::vector<Eigen::Vector3i> after = triangles_after(rings, v, to);
    if (!is_valid(mesh, after, settings.energy.delta) || overlaps_after(mesh, rings, v, after))
      continue;
    const double rise = energy_of(mesh, after, settings.energy) - energy;
    if (rise <= settings.largest_rise && (!best || rise < best->rise) &&
        largest_distortion(mesh, after) <= bound)
      best = Collapse{v, to, rise};
  }
  return best;
}

MeshPair without(const MeshPair& mesh, const Rings& rings, const std::vector<bool>& is_removed) {
  std::vector<int> new_index, kept;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    new_index.push_back(static_cast<int>(kept.size()));
    if (!is_removed[static_cast<std::size_t>(v)]) kept.push_back(v);
  }
  return {rings.triangles(new_index), mesh.rest()(Eigen::all, kept),
          mesh.deformed()(Eigen::all, kept)};
}

/// Every vertex that may go, best first.
std::vector<Collapse> collapses(const MeshPair& mesh, const Rings& rings,
                                const CollapseSettings& settings) {
  std::vector<Collapse> result;
  for (int v = settings.first_removable; v < mesh.vertex_count(); ++v) {
    if (rings.of(v).empty()) continue;
    if (const auto collapse = best_collapse(mesh, rings, v, settings)) result.push_back(*collapse);
  }
  std::ranges::stable_sort(result, {}, &Collapse::rise);
  return result;
}

}  // namespace

int collapse_edges(MeshPair& mesh, const CollapseSettings& settings) {
  if (settings.first_removable >= mesh.vertex_count()) return 0;
  Rings rings(mesh.triangles(), mesh.vertex_count());
  std::vector<bool> is_removed(static_cast<std::size_t>(mesh.vertex_count()), false);
  int removed = 0;
  for (bool is_gaining = true; is_gaining;) {
    is_gaining = false;
    for (const Collapse& planned : collapses(mesh, rings, settings)) {
      // What went before may have changed the triangles round it.
      const auto collapse = best_collapse(mesh, rings, planned.vertex, settings);
      if (!collapse) continue;
      rings.collapse(collapse->vertex, collapse->to);
      is_removed[static_cast<std::size_t>(collapse->vertex)] = true;
      ++removed;
      is_gaining = true;
    }
  }
  if (removed > 0) mesh = without(mesh, rings, is_removed);
  return removed;
}

}  // namespace foldless
