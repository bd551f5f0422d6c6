// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/tidy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/method/foldless/settle.h"
#include "core/method/foldless/transport.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::arrived_workspace;
using test::OwnWorkspace;
using test::StageRunner;

double rest_area(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(mesh.rest(), t);
  return sum;
}

TEST(Tidy, IsValidWhateverIsCancelledAndKeepsOriginalVerticesAndRestArea) {
  int removed = 0, cancelled = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed, 30);
    Workspace& work = own.work;
    const MeshPair before = work.mesh;
    const int kept = before.vertex_count() - 30;
    ASSERT_EQ(own.settings.first_removable, kept);
    StageRunner<void> runner(tidy(work));
    Points u = work.mesh.deformed();
    std::uint64_t revision = work.mesh.revision();
    cancelled += test::run_with_cancels(runner, seed, [&](bool was_cancelled) {
      if (was_cancelled) {
        EXPECT_EQ(work.mesh.deformed(), u);
        EXPECT_EQ(work.mesh.revision(), revision);
      }
      u = work.mesh.deformed();
      revision = work.mesh.revision();
      EXPECT_TRUE(test::is_valid(work.mesh));
    });
    removed += before.vertex_count() - work.mesh.vertex_count();
    EXPECT_EQ(work.mesh.rest().leftCols(kept), before.rest().leftCols(kept));
    EXPECT_NEAR(rest_area(work.mesh), rest_area(before), 1e-12);
    EXPECT_EQ(work.error(), 0);
  }
  EXPECT_GE(removed, 40 * 15) << "more than half";
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
}

TEST(Tidy, WithoutVerticesToRemoveItIsSettle) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace a = arrived_workspace(seed), b = arrived_workspace(seed);
    test::run_to_the_end(settle(a.work));
    if (is_crushed(a.work.mesh)) continue;
    test::run_to_the_end(tidy(b.work));
    EXPECT_EQ(a.effort.factorizations, b.effort.factorizations);
    EXPECT_EQ(a.work.mesh.deformed(), b.work.mesh.deformed());
  }
}

TEST(Tidy, OfARefinedMeshKeepsFewOfTheAddedVertices) {
  int added = 0, original = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = arrived_workspace(seed);
    const int kept = own.work.mesh.vertex_count();
    own.work.refine();
    ASSERT_GT(own.work.mesh.vertex_count(), 2 * kept);
    StageRunner<void> runner(tidy(own.work));
    while (!runner.has_ended()) {
      runner.step();
      ASSERT_TRUE(test::is_valid(own.work.mesh));
    }
    added += own.work.mesh.vertex_count() - kept;
    original += kept;
  }
  EXPECT_LE(added, 0.2 * original) << "of " << original;
}

TEST(Tidy, ARoundThatRaisedWhatSettleLowersIsUndone) {
  int undone = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    constexpr int kSplits = 8;
    OwnWorkspace settled = arrived_workspace(seed, kSplits),
                 tidied = arrived_workspace(seed, kSplits);
    if (kSplits > 0.1 * settled.settings.first_removable) continue;  // crowded: may rise by more
    test::run_to_the_end(settle(settled.work));
    // Vertices go before a round settles, and come back when it is undone.
    int rounds = 0;
    StageRunner<void> runner(tidy(tidied.work));
    for (int before = tidied.work.mesh.vertex_count(); !runner.has_ended();) {
      runner.step();
      const int now = tidied.work.mesh.vertex_count();
      rounds += now < before ? 1 : now > before ? -1 : 0;
      undone += now > before;
      before = now;
    }
    EXPECT_LE(merit_of(tidied.work), std::pow(1.01, rounds) * merit_of(settled.work));
  }
  EXPECT_GE(undone, 2) << "the claim would be empty";
}

TEST(Tidy, WhereATriangleIsStillCrushedItSettlesOnceMoreWithALargerExponent) {
  int crushed = 0;
  for (const std::uint64_t seed : {23, 24, 45}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::held_frame(seed);
    Workspace& work = own.work;
    const auto plans = transport_plans(work.handles(), work.constraints.targets, 0);
    test::run_to_the_end(transport_in_rounds(work, plans.front()));
    own.settings.first_removable = work.mesh.vertex_count();
    OwnWorkspace tidied(work.mesh, work.constraints, own.settings);
    test::run_to_the_end(settle(work));
    if (!is_crushed(work.mesh)) continue;
    ++crushed;
    test::run_to_the_end(tidy(tidied.work));
    EXPECT_LT(largest_distortion(tidied.work.mesh), 0.5 * largest_distortion(work.mesh));
  }
  EXPECT_GE(crushed, 2) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
