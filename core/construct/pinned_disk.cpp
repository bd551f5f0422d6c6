// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/pinned_disk.h"

#include <utility>

#include "core/construct/compatible_triangulation.h"
#include "core/construct/filled_disk.h"
#include "core/construct/held_disk.h"
#include "core/construct/slits.h"

namespace foldless {
namespace {

/// Polygons with more corners keep the triangles that slits left them, which cross oftener.
constexpr int kMostCornersTriangulated = 1000;

/// The banks of slits glued together.
MeshPair glued(const MeshPair& slit, const SlitDisks& disks) {
  const int corners = static_cast<int>(disks.rest.cols());
  const auto glued_vertex = [&](int v) {
    return v < corners ? disks.vertices[static_cast<std::size_t>(v)]
                       : disks.vertex_count + v - corners;
  };
  const int count = glued_vertex(slit.vertex_count());
  Points rest(2, count), deformed(2, count);
  for (int v = 0; v < slit.vertex_count(); ++v) {
    rest.col(glued_vertex(v)) = slit.rest().col(v);
    deformed.col(glued_vertex(v)) = slit.deformed().col(v);
  }
  return {slit.triangles().unaryExpr(glued_vertex), std::move(rest), std::move(deformed)};
}

}  // namespace

std::optional<MeshPair> with_pinned_disk(const MeshPair& mesh, const PinnedVertices& pinned,
                                         const Points& targets, int choice) {
  const auto& [loop, inside] = pinned;
  const auto corners = static_cast<Eigen::Index>(loop.size());
  if (corners > kMostCornersOfADisk) return std::nullopt;
  std::vector<int> vertices = loop;
  vertices.insert(vertices.end(), inside.begin(), inside.end());
  const std::vector<SlitDisks> ways =
      slit_open({mesh.rest()(Eigen::all, loop), mesh.rest()(Eigen::all, inside)},
                {targets.leftCols(corners), targets.rightCols(targets.cols() - corners)});
  for (std::size_t way = static_cast<std::size_t>(choice); way < ways.size(); ++way) {
    const auto slit = compatible_triangulation(ways[way], kMostCornersTriangulated);
    if (!slit) continue;
    std::optional<MeshPair> whole = filled(glued(*slit, ways[way]), vertices, mesh);
    if (whole) return whole;
  }
  return std::nullopt;
}

}  // namespace foldless
