// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/pinned_disk.h"

#include <array>
#include <utility>
#include <vector>

#include "core/construct/braids.h"
#include "core/construct/compatible_triangulation.h"
#include "core/construct/filled_disk.h"
#include "core/construct/held_disk.h"
#include "core/construct/slits.h"

namespace foldless {
namespace {

/// Polygons with more corners keep the triangles that slits left them, which cross oftener. Braids
/// have left them none.
constexpr int kMostCornersTriangulated = 1000;
/// The slits of a braid are taken while they leave up to so many times the vertices that the
/// shortest ones leave: maps are the better for the class.
constexpr double kMostTimesVertices = 2.5;

/// A class of maps: of the searches for braids and slits, and whether the one of the two that looks
/// worse is taken.
struct Class {
  int search;
  bool is_second;
};
constexpr std::array<Class, kClassesOfPinnedDisks> kClasses{
    {{0, false}, {1, false}, {0, true}, {2, false}}};

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

/// The map of the disk that the slits lead to, on their vertices alone.
std::optional<MeshPair> map_of(const SlitDisks& disks) {
  const auto slit = compatible_triangulation(disks, kMostCornersTriangulated);
  if (!slit) return std::nullopt;
  return glued(*slit, disks);
}

/// The one that the braid leads to.
std::optional<MeshPair> map_of_braid(const DottedDisk& rest, const DottedDisk& deformed,
                                     int search) {
  const std::optional<SlitDisks> disks = braided(rest, deformed, search);
  return disks ? map_of(*disks) : std::nullopt;
}

}  // namespace

std::optional<MeshPair> with_pinned_disk(const MeshPair& mesh, const PinnedVertices& pinned,
                                         const Points& targets, int choice) {
  const auto& [loop, inside] = pinned;
  const auto corners = static_cast<Eigen::Index>(loop.size());
  if (corners > kMostCornersOfADisk || choice >= kClassesOfPinnedDisks) return std::nullopt;
  std::vector<int> vertices = loop;
  vertices.insert(vertices.end(), inside.begin(), inside.end());
  const DottedDisk rest{mesh.rest()(Eigen::all, loop), mesh.rest()(Eigen::all, inside)};
  const DottedDisk deformed{targets.leftCols(corners), targets.rightCols(targets.cols() - corners)};
  const auto [search, is_second] = kClasses[static_cast<std::size_t>(choice)];
  const std::vector<SlitDisks> ways = slit_open(rest, deformed);
  auto way = static_cast<std::size_t>(search);
  std::optional<MeshPair> first = map_of_braid(rest, deformed, search);
  std::optional<MeshPair> second = way < ways.size() ? map_of(ways[way]) : std::nullopt;
  const bool is_braid_complex =
      first && second && first->vertex_count() > kMostTimesVertices * second->vertex_count();
  if (is_braid_complex != is_second) std::swap(first, second);
  for (const std::optional<MeshPair>& map : {first, second})
    if (map)
      if (std::optional<MeshPair> whole = filled(*map, vertices, mesh)) return whole;
  while (++way < ways.size())
    if (const std::optional<MeshPair> map = map_of(ways[way]))
      if (std::optional<MeshPair> whole = filled(*map, vertices, mesh)) return whole;
  return std::nullopt;
}

}  // namespace foldless
