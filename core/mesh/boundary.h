// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/orientation.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// The neighbours of a boundary vertex v along the boundary, which runs from `previous` over v to
/// `next` with the mesh on its left: the triangles at v fill the angle from `next`,
/// counter-clockwise, to `previous`. Flips of edges change neither.
struct BoundaryNeighbours {
  int next = -1, previous = -1;  ///< −1: v is not at the boundary
  bool are_there() const { return next >= 0; }
};

/// The ends of a chain of link edges, found without their order: over the edges (a, b) of the chain
/// from n to p the sums of a − b and a² − b² are n − p and n² − p².
class LinkEnds {
 public:
  /// Of the counter-clockwise triangle (v, a, b).
  void add(int a, int b) {
    const auto square = [](int i) {
      return static_cast<std::uint64_t>(i) * static_cast<std::uint64_t>(i);
    };
    difference_ += a - b;
    difference_of_squares_ += square(a) - square(b);
  }
  /// None where the chain is closed, or empty.
  BoundaryNeighbours neighbours() const;

 private:
  std::int64_t difference_ = 0;
  std::uint64_t difference_of_squares_ = 0;  ///< unsigned, so that sums on the way may wrap
};

/// Those of every vertex. Precondition: oriented manifold triangles with indices in
/// [0, vertex_count). O(#V + #F).
std::vector<BoundaryNeighbours> boundary_neighbours(const Triangles& triangles, int vertex_count);

/// The vertices along the boundary from `start`, one of it, once round, the mesh on the left.
std::vector<int> boundary_loop(const std::vector<BoundaryNeighbours>& neighbours, int start);

/// Marks, by vertex, the boundary vertices of a counter-clockwise triangle whose angles it takes to
/// 2π or more; `neighbours` are those of every vertex. With all triangles at a vertex
/// counter-clockwise one of them does so exactly where it overlaps itself. Exact.
void mark_overlaps(const Eigen::Vector3i& triangle, const Points& points,
                   const std::vector<BoundaryNeighbours>& neighbours, std::vector<char>& overlaps);

/// Whether it would mark one.
bool has_overlap(const Eigen::Vector3i& triangle, const Points& points,
                 const std::vector<BoundaryNeighbours>& neighbours);

/// Whether the angles at v add up to 2π or more, from all of its triangles: it then overlaps
/// itself, or closes the gap between its two boundary edges. Never at an interior vertex.
/// Precondition: they are counter-clockwise. Exact.
bool overlaps_itself(int v, std::span<const Eigen::Vector3i> triangles, const Points& points);

}  // namespace foldless
