// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/construct/slits.h"
#include "tests/support/pinned_disks.h"

namespace foldless::test {

/// A disk and its image, in which points inside change places.
inline std::pair<DottedDisk, DottedDisk> dotted_disks(std::uint64_t seed, int inside) {
  const PinnedDisk disk = permuted_disk(seed, inside);
  const Points& rest = disk.mesh.rest();
  return {{rest(Eigen::all, disk.pinned.loop), rest(Eigen::all, disk.pinned.inside)},
          {disk.targets.leftCols(disk.targets.cols() - inside), disk.targets.rightCols(inside)}};
}

/// All corners of a vertex are where it is.
inline void expect_banks_together(const Points& corners, const std::vector<int>& vertices,
                                  const DottedDisk& disk) {
  Points where = Points::Constant(2, 1 + *std::ranges::max_element(vertices), 1e9);
  where.leftCols(disk.outline.cols()) = disk.outline;
  where.middleCols(disk.outline.cols(), disk.inside.cols()) = disk.inside;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    auto place = where.col(vertices[i]);
    if (place.x() == 1e9) place = corners.col(static_cast<Eigen::Index>(i));
    EXPECT_EQ(Vec2(place), Vec2(corners.col(static_cast<Eigen::Index>(i)))) << i;
  }
}

}  // namespace foldless::test
