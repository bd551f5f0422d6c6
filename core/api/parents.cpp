// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/api/parents.h"

#include <numeric>
#include <vector>

#include "core/motion/frame_map.h"
#include "core/multires/holding_triangles.h"

namespace foldless {
namespace {

/// Rounding may have put a vertex of a split beside its edge.
Eigen::Vector3d coordinates_in(const Points& rest, const Eigen::Vector3i& triangle, int vertex) {
  const Eigen::Vector3d inside =
      barycentric(corners_of(rest, triangle), rest.col(vertex)).cwiseMax(0.0);
  return inside / inside.sum();
}

}  // namespace

Parents parents_of(const Snapshot& snapshot, const Triangles& input) {
  const Points& rest = *snapshot.rest;
  CoarseMesh coarse{MeshPair(input, rest.leftCols(snapshot.original_vertices)), {}};
  coarse.vertices.resize(static_cast<std::size_t>(snapshot.original_vertices));
  std::iota(coarse.vertices.begin(), coarse.vertices.end(), 0);
  const std::vector<int> holding =
      holding_triangles(coarse, MeshPair(*snapshot.triangles, rest, snapshot.deformed));

  Parents parents;
  parents.triangles.resize(rest.cols());
  parents.coordinates.setZero(rest.cols(), 3);
  parents.outputs =
      Eigen::VectorXi::LinSpaced(snapshot.original_vertices, 0, snapshot.original_vertices - 1);
  for (int v = 0; v < rest.cols(); ++v) {
    const int triangle = holding[static_cast<std::size_t>(v)];
    parents.triangles[v] = triangle;
    if (triangle < 0) continue;
    const Eigen::Vector3i corners = input.col(triangle);
    if (v < snapshot.original_vertices)
      parents.coordinates.row(v) = (corners.array() == v).cast<double>();
    else
      parents.coordinates.row(v) = coordinates_in(rest, corners, v);
  }
  return parents;
}

}  // namespace foldless
