// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/pinned_disk.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/pinned_disks.h"
#include "tests/support/sanitizers.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::PinnedDisk;

void expect_pinned(const MeshPair& mesh, const PinnedDisk& disk) {
  EXPECT_TRUE(test::is_valid(mesh));
  EXPECT_EQ(mesh.rest().leftCols(disk.mesh.vertex_count()), disk.mesh.rest());
  std::vector<int> vertices = disk.pinned.loop;
  vertices.insert(vertices.end(), disk.pinned.inside.begin(), disk.pinned.inside.end());
  EXPECT_EQ(Points(mesh.deformed()(Eigen::all, vertices)), disk.targets);
  for (std::size_t i = 0; i < disk.pinned.loop.size(); ++i) {
    const auto side =
        mesh.find_edge(disk.pinned.loop[i], disk.pinned.loop[(i + 1) % disk.pinned.loop.size()]);
    EXPECT_TRUE(side && mesh.is_boundary_edge(*side));
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_FALSE(mesh.is_isolated(v)) << v;
}

TEST(PinnedDisk, SwapsTwoVerticesInsideOfAHeldBoundary) {
  for (std::uint64_t seed = 1; seed <= test::seeds(20); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PinnedDisk disk = test::permuted_disk(seed, 2);
    const auto mesh = with_pinned_disk(disk.mesh, disk.pinned, disk.targets);
    ASSERT_TRUE(mesh);
    expect_pinned(*mesh, disk);
  }
}

TEST(PinnedDisk, BringsEightVerticesToEachOthersPlacesInAnyOrder) {
  for (std::uint64_t seed = 1; seed <= test::seeds(10); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PinnedDisk disk = test::permuted_disk(seed, 8);
    const auto mesh = with_pinned_disk(disk.mesh, disk.pinned, disk.targets);
    ASSERT_TRUE(mesh);
    expect_pinned(*mesh, disk);
  }
}

TEST(PinnedDisk, OtherChoicesLeadToOtherMapsUntilNoneIsLeft) {
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const PinnedDisk disk = test::permuted_disk(seed, 5);
    const auto first = with_pinned_disk(disk.mesh, disk.pinned, disk.targets);
    ASSERT_TRUE(first);
    const int vertices = disk.mesh.vertex_count();
    // Searches for braids may find the same.
    bool is_other = false;
    for (int choice = 1; choice < kClassesOfPinnedDisks; ++choice) {
      const auto other = with_pinned_disk(disk.mesh, disk.pinned, disk.targets, choice);
      ASSERT_TRUE(other);
      expect_pinned(*other, disk);
      if (first->deformed().leftCols(vertices) != other->deformed().leftCols(vertices))
        is_other = true;
    }
    if (is_other) ++others;
    EXPECT_FALSE(with_pinned_disk(disk.mesh, disk.pinned, disk.targets, kClassesOfPinnedDisks));
  }
  EXPECT_GE(others, 3);
}

TEST(PinnedDisk, TheBoundaryMayGoToAnotherPolygon) {
  for (std::uint64_t seed = 1; seed <= test::seeds(20); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    PinnedDisk disk = test::permuted_disk(seed, 4);
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < disk.pinned.loop.size(); i += 2)
      disk.targets.col(static_cast<Eigen::Index>(i)) *=
          1.2 + 0.1 * static_cast<double>(random() % 20);
    const auto mesh = with_pinned_disk(disk.mesh, disk.pinned, disk.targets);
    ASSERT_TRUE(mesh);
    expect_pinned(*mesh, disk);
  }
}

TEST(PinnedDisk, IsNothingWhereATargetIsOutsideOrOnTheBoundaryOrSharedByTwo) {
  const PinnedDisk disk = test::permuted_disk(1, 3);
  const auto with_target = [&](const Vec2& target) {
    Points targets = disk.targets;
    targets.rightCols<1>() = target;
    return with_pinned_disk(disk.mesh, disk.pinned, targets);
  };
  EXPECT_TRUE(with_target(disk.targets.rightCols<1>()));
  EXPECT_FALSE(with_target(Vec2(1.5, 0)));
  EXPECT_FALSE(with_target(0.5 * (disk.targets.col(0) + disk.targets.col(1))));
  EXPECT_FALSE(with_target(disk.targets.col(3)));
  EXPECT_FALSE(with_target(disk.targets.col(disk.targets.cols() - 2)));
}

}  // namespace
}  // namespace foldless
