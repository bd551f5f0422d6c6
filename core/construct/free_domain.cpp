// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/free_domain.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/construct/engraved.h"
#include "core/construct/filled_disk.h"
#include "core/construct/pinned_map.h"

namespace foldless {
namespace {

/// Of the rectangle round everything, in its diagonals.
constexpr double kMargin = 0.25;

/// Counter-clockwise, round both.
Points rectangle_round(const Points& rest, const Points& targets) {
  const Vec2 least = rest.rowwise().minCoeff().cwiseMin(targets.rowwise().minCoeff());
  const Vec2 most = rest.rowwise().maxCoeff().cwiseMax(targets.rowwise().maxCoeff());
  const double margin = kMargin * (most - least).norm();
  const Vec2 a = least.array() - margin, c = most.array() + margin;
  Points corners(2, 4);
  corners << a.x(), c.x(), c.x(), a.x(), a.y(), a.y(), c.y(), c.y();
  return corners;
}

}  // namespace

std::optional<MeshPair> with_free_domain(const MeshPair& mesh, const PinnedDomain& domain,
                                         const Points& targets, int choice) {
  std::vector<int> corners;
  for (const std::vector<int>& loop : domain.loops)
    corners.insert(corners.end(), loop.begin(), loop.end());
  const Points rectangle = rectangle_round(mesh.rest()(Eigen::all, corners), targets);
  // The map has the corners of the rectangle first, then what is pinned.
  std::vector<int> vertex_of_map(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (std::size_t i = 0; i < domain.pinned.size(); ++i)
    vertex_of_map[static_cast<std::size_t>(domain.pinned[i])] =
        static_cast<int>(rectangle.cols()) + static_cast<int>(i);
  std::vector<std::vector<OutlineCorner>> loops;
  for (const std::vector<int>& loop : domain.loops) {
    loops.emplace_back();
    for (const int v : loop)
      loops.back().push_back({mesh.rest().col(v), vertex_of_map[static_cast<std::size_t>(v)]});
  }
  for (const int v : domain.pinned)
    if (std::ranges::find(corners, v) == corners.end()) corners.push_back(v);
  const auto within = [&](const MeshPair& whole) -> std::optional<MeshPair> {
    const std::optional<MeshPair> part = engraved(whole, loops);
    if (!part) return std::nullopt;
    return filled(*part, corners, mesh);
  };
  return pinned_map({rectangle, mesh.rest()(Eigen::all, domain.pinned)}, {rectangle, targets},
                    choice, within);
}

}  // namespace foldless
