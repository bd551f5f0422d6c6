// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/pinned_map.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/construct/braids.h"
#include "core/construct/compatible_triangulation.h"

namespace foldless {
namespace {

/// Polygons with more corners keep the triangles that slits left them, which cross oftener.
constexpr int kMostCornersTriangulated = 1000;
/// A braid that leaves more is of no use: the shortest slits are better then.
constexpr int kMostCornersOfABraid = 450;

/// Where maps of a class come from, and from which search there.
struct Class {
  enum class From { braid, slits } from;
  int search;
};
constexpr std::array<Class, kClassesOfPinnedDisks> kClasses{{{Class::From::braid, 0},
                                                             {Class::From::braid, 1},
                                                             {Class::From::slits, 0},
                                                             {Class::From::braid, 2},
                                                             {Class::From::braid, 3},
                                                             {Class::From::braid, 4}}};
static_assert(kClasses[kClassOfShortestSlits].from == Class::From::slits);

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

std::optional<MeshPair> pinned_map(const DottedDisk& rest, const DottedDisk& deformed, int choice,
                                   const UseOfMap& use) {
  if (choice >= kClassesOfPinnedDisks) return std::nullopt;
  const auto map_along = [&](const SlitDisks& disks) -> std::optional<MeshPair> {
    const auto slit = compatible_triangulation(disks, kMostCornersTriangulated);
    if (!slit) return std::nullopt;
    return use(glued(*slit, disks));
  };
  const auto [from, search] = kClasses[static_cast<std::size_t>(choice)];
  if (from == Class::From::braid) {
    const std::optional<SlitDisks> braid = braided(rest, deformed, search);
    if (braid && braid->rest.cols() <= kMostCornersOfABraid)
      if (std::optional<MeshPair> map = map_along(*braid)) return map;
  }
  const std::vector<SlitDisks> ways = slit_open(rest, deformed);
  for (auto way = static_cast<std::size_t>(search); way < ways.size(); ++way)
    if (std::optional<MeshPair> map = map_along(ways[way])) return map;
  return std::nullopt;
}

}  // namespace foldless
