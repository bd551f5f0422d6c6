// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/energy/densities.h"
#include "core/method/foldless/cut_to_handles.h"
#include "tests/support/pinned_disks.h"

namespace foldless::test {

/// A disk with handles inside that change places, its boundary held or, of every second vertex,
/// free.
inline Problem permutation(std::uint64_t seed, int inside,
                           CutBoundary boundary = CutBoundary::held) {
  const test::PinnedDisk disk = test::permuted_disk(seed, inside);
  Problem problem{disk.mesh, find_density("arap"), {}, {}};
  std::vector<int> vertices = disk.pinned.loop;
  vertices.insert(vertices.end(), disk.pinned.inside.begin(), disk.pinned.inside.end());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (boundary == CutBoundary::held || i >= disk.pinned.loop.size() || i % 2 == 0)
      problem.handles.push_back({.id = static_cast<int>(i) + 1,
                                 .vertex = vertices[i],
                                 .target = disk.targets.col(static_cast<Eigen::Index>(i))});
  return problem;
}

}  // namespace foldless::test
