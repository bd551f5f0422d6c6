// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/refine_crushed.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

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

TEST(RefineCrushed, GivesRoomBetweenHandlesAndShowsNothingWorseWhateverIsCancelled) {
  int cancelled = 0, crushed = 0, uncrushed = 0, vertices = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::held_frame(seed, 16);
    Workspace& work = own.work;
    if (!test::arrive_distorted(work)) continue;
    if (!is_crushed(work.mesh)) continue;
    const double energy = settled_energy(work);
    double distortion = largest_distortion(work.mesh);
    StageRunner<void> runner(refine_crushed(work));
    cancelled += test::run_with_cancels(runner, seed, [&](bool) {
      EXPECT_TRUE(test::is_valid(work.mesh));
      const double before = std::exchange(distortion, largest_distortion(work.mesh));
      EXPECT_LE(distortion, before);
    });
    ++crushed;
    vertices += work.mesh.vertex_count();
    if (!is_crushed(work.mesh)) ++uncrushed;
    EXPECT_EQ(work.error(), 0);
    EXPECT_LE(settled_energy(work), 10 * energy);
  }
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
  EXPECT_GE(crushed, 6) << "the claim would be empty";
  EXPECT_GE(3 * uncrushed, 2 * crushed);
  EXPECT_LT(vertices, 235 * crushed) << "rounds that do not help leave no vertices";
}

TEST(RefineCrushed, CostsNothingWhereNothingIsCrushedOrTheMeshIsLarge) {
  const auto splits_of_squeezed = [](int cells, double factor) {
    OwnWorkspace own = test::squeezed_workspace(cells, factor);
    StageRunner<void> runner(refine_crushed(own.work));
    runner.run(1);
    return own.effort.splits;
  };
  EXPECT_EQ(splits_of_squeezed(6, 990), 0);
  EXPECT_GT(splits_of_squeezed(6, 1010), 0);
  EXPECT_EQ(splits_of_squeezed(40, 1010), 0);
}

TEST(RefineCrushed, LeavesTheMeshAsItIsWhereNoEdgeMayBeSplit) {
  // The boundary is held as a whole, and there is nothing but the boundary.
  Triangles triangles(3, 1);
  triangles << 0, 1, 2;
  Points rest(2, 3), u(2, 3);
  rest << 0, 1, 0, 0, 0, 1;
  u << 0, 1, 0.5, 0, 0, 1e-4;
  std::vector<Handle> handles;
  for (int v = 0; v < 3; ++v) handles.push_back({.id = v, .vertex = v, .target = u.col(v)});
  OwnWorkspace own = test::workspace_of(MeshPair(triangles, rest, u), handles);
  own.settings.fixed_boundary = {0, 1, 2};
  test::run_to_the_end(refine_crushed(own.work));
  EXPECT_EQ(own.work.mesh.vertex_count(), 3);
  EXPECT_EQ(own.effort.factorizations, 0);
}

}  // namespace
}  // namespace foldless
