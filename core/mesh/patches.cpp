// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/patches.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/mesh/components.h"

namespace foldless {
namespace {

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// A free corner; −1 where there is none.
int free_corner(const Eigen::Vector3i& triangle, const std::vector<bool>& is_free) {
  for (const int v : triangle)
    if (is_free[at(v)]) return v;
  return -1;
}

/// The triangles of every patch.
std::vector<std::vector<int>> groups(const Triangles& triangles, const std::vector<bool>& is_free) {
  Triangles of_free(3, triangles.cols());  // vertices that are not free connect nothing
  Eigen::Index count = 0;
  for (const Eigen::Vector3i t : triangles.colwise())
    if (const int v = free_corner(t, is_free); v >= 0)
      of_free.col(count++) = t.unaryExpr([&](int w) { return is_free[at(w)] ? w : v; });
  const std::vector<int> component =
      components_of(of_free.leftCols(count), static_cast<int>(is_free.size()));

  std::vector<std::vector<int>> result;
  std::vector<int> group_of(is_free.size(), -1);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const int v = free_corner(triangles.col(t), is_free);
    if (v < 0) continue;
    int& group = group_of[at(component[at(v)])];
    if (group < 0) {
      group = static_cast<int>(result.size());
      result.emplace_back();
    }
    result[at(group)].push_back(static_cast<int>(t));
  }
  return result;
}

/// An edge of a triangle with the two corners 3 t + c at its ends.
struct TriangleSide {
  std::array<int, 2> ends, corners;
};

/// For every corner 3 t + c of the triangles at a vertex that is not free a number that two corners
/// share when they are at one vertex, and triangles that share edges lead round it from one to the
/// other.
std::vector<int> fans(const Triangles& triangles, const std::vector<bool>& is_free) {
  std::vector<TriangleSide> sides;
  for (int t = 0; t < triangles.cols(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int next = (c + 1) % 3;
      if (is_free[at(triangles(c, t))] && is_free[at(triangles(next, t))]) continue;
      TriangleSide side{{triangles(c, t), triangles(next, t)}, {3 * t + c, 3 * t + next}};
      if (side.ends[0] > side.ends[1]) {
        std::swap(side.ends[0], side.ends[1]);
        std::swap(side.corners[0], side.corners[1]);
      }
      sides.push_back(side);
    }
  std::ranges::sort(sides, {}, [](const TriangleSide& side) { return side.ends; });
  Triangles joined(3, 2 * static_cast<Eigen::Index>(sides.size()));
  Eigen::Index count = 0;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].ends != sides[i - 1].ends) continue;
    for (const std::size_t end : {0U, 1U}) {
      const int here = sides[i].corners[end];
      joined.col(count++) << here, here, sides[i - 1].corners[end];
    }
  }
  return components_of(joined.leftCols(count), static_cast<int>(3 * triangles.cols()));
}

/// Writes to `place_of` where a free vertex is in its patch; −1 before.
Patch patch_of(const Triangles& triangles, const std::vector<bool>& is_free,
               std::vector<int>& place_of) {
  Patch patch{Triangles(3, triangles.cols()), {}};
  const std::vector<int> fan = fans(triangles, is_free);
  std::vector<int> place_of_fan(fan.size(), -1);
  for (Eigen::Index corner = 0; corner < triangles.size(); ++corner) {
    const int v = triangles.reshaped()[corner];
    int& place = is_free[at(v)] ? place_of[at(v)] : place_of_fan[at(fan[at(corner)])];
    if (place < 0) {
      place = static_cast<int>(patch.vertices.size());
      patch.vertices.push_back(v);
    }
    patch.triangles.reshaped()[corner] = place;
  }
  return patch;
}

}  // namespace

void grow(std::vector<bool>& is_marked, const Triangles& triangles, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<bool> grown = is_marked;
    for (const Eigen::Vector3i t : triangles.colwise())
      if (free_corner(t, is_marked) >= 0)
        for (const int v : t) grown[at(v)] = true;
    is_marked = std::move(grown);
  }
}

std::vector<Patch> patches(const Triangles& triangles, const std::vector<bool>& is_free) {
  std::vector<Patch> result;
  std::vector<int> place_of(is_free.size(), -1);
  for (const std::vector<int>& group : groups(triangles, is_free))
    result.push_back(patch_of(triangles(Eigen::all, group), is_free, place_of));
  return result;
}

}  // namespace foldless
