// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/refine_distorted.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"
#include "tests/core/method/foldless/refine_workspaces.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

TEST(RefineDistorted, ShowsNothingButMuchLowerEnergyAndIsValidWhateverIsCancelled) {
  int cancelled = 0, distorted = 0, better = 0, ended_with_little = 0;
  for (std::uint64_t seed = 361; seed <= 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::held_frame(seed, 10);
    Workspace& work = own.work;
    if (!test::arrive_distorted(work)) continue;
    if (is_crushed(work.mesh) || largest_distortion(work.mesh) < 50) continue;
    ++distorted;
    const double begin = merit_of(work), most_vertices = 1.5 * work.mesh.vertex_count();
    double merit = begin;
    int splits = own.effort.splits;
    StageRunner<void> runner(refine_distorted(work));
    cancelled += test::run_with_cancels(runner, seed, [&](bool) {
      EXPECT_TRUE(test::is_valid(work.mesh));
      EXPECT_FALSE(is_crushed(work.mesh));
      const double before = std::exchange(merit, merit_of(work));
      EXPECT_TRUE(merit == before || merit <= 0.95 * before) << before << " to " << merit;
      const int splits_before = std::exchange(splits, own.effort.splits);
      if (merit == before || merit <= 0.9 * before) return;
      EXPECT_EQ(splits, splits_before) << "it goes on after a round that gained little";
      ++ended_with_little;
    });
    better += merit < begin;
    EXPECT_EQ(work.error(), 0);
    EXPECT_LE(work.mesh.vertex_count(), most_vertices);
  }
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
  EXPECT_GE(distorted, 8) << "the claim would be empty";
  EXPECT_GE(2 * better, distorted);
  EXPECT_GT(ended_with_little, 0) << "the claim would be empty";
}

// To split an edge of each would take more than half of the vertices.
TEST(RefineDistorted, SplitsAsMuchAsThereIsRoomForWhereAllIsDistorted) {
  OwnWorkspace own = test::squeezed_workspace(6, 60);
  Workspace& work = own.work;
  const int vertices = work.mesh.vertex_count();
  const double before = merit_of(work);
  test::run_to_the_end(refine_distorted(work));
  EXPECT_LT(merit_of(work), 0.95 * before);
  EXPECT_EQ(own.effort.splits, vertices / 2);
}

TEST(RefineDistorted, CostsNothingWhereNothingIsDistortedOrIsCrushedOrTheMeshIsLarge) {
  const auto splits_of_squeezed = [](int cells, double factor) {
    OwnWorkspace own = test::squeezed_workspace(cells, factor);
    StageRunner<void> runner(refine_distorted(own.work));
    runner.run(1);
    return own.effort.splits;
  };
  EXPECT_EQ(splits_of_squeezed(6, 49), 0);
  EXPECT_GT(splits_of_squeezed(6, 51), 0);
  EXPECT_EQ(splits_of_squeezed(6, 1010), 0);
  EXPECT_GT(splits_of_squeezed(44, 51), 0);
  EXPECT_EQ(splits_of_squeezed(45, 51), 0);
}

}  // namespace
}  // namespace foldless
