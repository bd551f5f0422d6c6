// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/pinned_disk.h"

#include "core/construct/filled_disk.h"
#include "core/construct/held_disk.h"

namespace foldless {

std::optional<MeshPair> with_pinned_disk(const MeshPair& mesh, const PinnedVertices& pinned,
                                         const Points& targets, int choice) {
  const auto& [loop, inside] = pinned;
  const auto corners = static_cast<Eigen::Index>(loop.size());
  if (corners > kMostCornersOfADisk) return std::nullopt;
  std::vector<int> vertices = loop;
  vertices.insert(vertices.end(), inside.begin(), inside.end());
  return pinned_map({mesh.rest()(Eigen::all, loop), mesh.rest()(Eigen::all, inside)},
                    {targets.leftCols(corners), targets.rightCols(targets.cols() - corners)},
                    choice, [&](const MeshPair& map) { return filled(map, vertices, mesh); });
}

}  // namespace foldless
