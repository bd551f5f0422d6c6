// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary.h"

#include <algorithm>
#include <cstddef>

namespace foldless {
namespace boundary {

/// Calls visit(v, a, b) for every corner of a counter-clockwise triangle.
template <typename Visit>
void for_each_corner(const Eigen::Vector3i& t, const Visit& visit) {
  visit(t[0], t[1], t[2]);
  visit(t[1], t[2], t[0]);
  visit(t[2], t[0], t[1]);
}

/// True when the counter-clockwise triangle t = (v, a, b) holds the edge to `next` as its last side
/// or behind its first.
bool comes_round_to_next(const Points& points, const Eigen::Vector3i& t, int next) {
  if (t[1] == next) return false;  // as exact arithmetic would find of every first triangle
  return orientation(points, {t[0], t[1], next}) > 0 &&
         orientation(points, {t[0], next, t[2]}) >= 0;
}

/// Calls visit(v) for every corner of a counter-clockwise triangle that overlaps there.
template <typename Visit>
void for_each_overlap(const Eigen::Vector3i& triangle, const Points& points,
                      const std::vector<BoundaryNeighbours>& neighbours, const Visit& visit) {
  for_each_corner(triangle, [&](int v, int a, int b) {
    const BoundaryNeighbours& of_v = neighbours[static_cast<std::size_t>(v)];
    if (of_v.are_there() && comes_round_to_next(points, {v, a, b}, of_v.next)) visit(v);
  });
}

}  // namespace boundary

BoundaryNeighbours LinkEnds::neighbours() const {
  if (difference_ == 0) return {};
  const std::int64_t sum = static_cast<std::int64_t>(difference_of_squares_) / difference_;
  return {static_cast<int>((sum + difference_) / 2), static_cast<int>((sum - difference_) / 2)};
}

std::vector<BoundaryNeighbours> boundary_neighbours(const Triangles& triangles, int vertex_count) {
  std::vector<LinkEnds> ends(static_cast<std::size_t>(vertex_count));
  for (const auto& t : triangles.colwise())
    boundary::for_each_corner(
        t, [&](int v, int a, int b) { ends[static_cast<std::size_t>(v)].add(a, b); });
  std::vector<BoundaryNeighbours> neighbours(ends.size());
  std::ranges::transform(ends, neighbours.begin(), &LinkEnds::neighbours);
  return neighbours;
}

std::vector<int> boundary_loop(const std::vector<BoundaryNeighbours>& neighbours, int start) {
  std::vector<int> loop;
  int v = start;
  do {
    loop.push_back(v);
    v = neighbours[static_cast<std::size_t>(v)].next;
  } while (v != start);
  return loop;
}

void mark_overlaps(const Eigen::Vector3i& triangle, const Points& points,
                   const std::vector<BoundaryNeighbours>& neighbours, std::vector<char>& overlaps) {
  boundary::for_each_overlap(triangle, points, neighbours,
                             [&](int v) { overlaps[static_cast<std::size_t>(v)] = 1; });
}

bool has_overlap(const Eigen::Vector3i& triangle, const Points& points,
                 const std::vector<BoundaryNeighbours>& neighbours) {
  bool found = false;
  boundary::for_each_overlap(triangle, points, neighbours, [&](int) { found = true; });
  return found;
}

bool overlaps_itself(int v, std::span<const Eigen::Vector3i> triangles, const Points& points) {
  LinkEnds ends;
  const auto for_each_of_v = [&](const auto& visit) {
    for (const Eigen::Vector3i& t : triangles)
      boundary::for_each_corner(t, [&](int corner, int a, int b) {
        if (corner == v) visit(a, b);
      });
  };
  for_each_of_v([&](int a, int b) { ends.add(a, b); });
  const BoundaryNeighbours neighbours = ends.neighbours();
  bool overlaps = false;
  for_each_of_v([&](int a, int b) {
    overlaps = overlaps || (neighbours.are_there() &&
                            boundary::comes_round_to_next(points, {v, a, b}, neighbours.next));
  });
  return overlaps;
}

}  // namespace foldless
