// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/held_disk.h"

#include "core/construct/compatible_triangulation.h"
#include "core/construct/filled_disk.h"

namespace foldless {

std::optional<MeshPair> with_held_disk(const MeshPair& mesh, const std::vector<int>& loop,
                                       const Points& targets) {
  if (static_cast<int>(loop.size()) > kMostCornersOfADisk) return std::nullopt;
  const std::optional<MeshPair> coarse =
      compatible_triangulation(mesh.rest()(Eigen::all, loop), targets);
  if (!coarse) return std::nullopt;
  return filled(*coarse, loop, mesh);
}

}  // namespace foldless
