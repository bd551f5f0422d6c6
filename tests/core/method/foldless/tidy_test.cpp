// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/tidy.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/settle_fixture.h"

namespace foldless {
namespace {

using test::arrived_workspace;

double rest_area(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(mesh.rest(), t);
  return sum;
}

TEST(Tidy, IsValidWhateverIsCancelledAndKeepsOriginalVerticesAndRestArea) {
  int removed = 0, cancelled = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::stop_source stopped;
    stopped.request_stop();
    Workspace workspace = arrived_workspace(seed, 30);
    const MeshPair before = workspace.mesh;
    const int kept = before.vertex_count() - 30;
    Tidy tidy(workspace, kept);
    VertexUpdate update;
    Progress progress = Progress::running;
    while (progress != Progress::arrived) {
      const bool stops = random() % 3 == 0;
      const Points u = workspace.mesh.deformed();
      const std::uint64_t revision = workspace.mesh.revision();
      progress = tidy.step(workspace, stops ? stopped.get_token() : std::stop_token(), update);
      if (progress == Progress::cancelled) {
        ++cancelled;
        EXPECT_EQ(workspace.mesh.deformed(), u);
        EXPECT_EQ(workspace.mesh.revision(), revision);
      }
      ASSERT_TRUE(test::is_valid(workspace.mesh));
    }
    removed += before.vertex_count() - workspace.mesh.vertex_count();
    EXPECT_EQ(workspace.mesh.rest().leftCols(kept), before.rest().leftCols(kept));
    EXPECT_NEAR(rest_area(workspace.mesh), rest_area(before), 1e-12);
    EXPECT_EQ(workspace.error(), 0);
  }
  EXPECT_GE(removed, 40 * 15) << "more than half";
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
}

TEST(Tidy, WithoutVerticesToRemoveItIsSettle) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Workspace a = arrived_workspace(seed), b = arrived_workspace(seed);
    Settle settle(a);
    Tidy tidy(b, b.mesh.vertex_count());
    VertexUpdate update;
    Progress of_settle = Progress::running, of_tidy = Progress::running;
    while (of_settle == Progress::running && of_tidy == Progress::running) {
      of_settle = settle.step(a, {}, update);
      of_tidy = tidy.step(b, {}, update);
    }
    EXPECT_EQ(of_settle, of_tidy);
    EXPECT_EQ(a.system.counters.factorizations, b.system.counters.factorizations);
  }
}

TEST(Tidy, OfARefinedMeshKeepsFewOfTheAddedVertices) {
  int added = 0, original = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Workspace workspace = arrived_workspace(seed);
    const int kept = workspace.mesh.vertex_count();
    workspace.refine();
    ASSERT_GT(workspace.mesh.vertex_count(), 2 * kept);
    Tidy tidy(workspace, kept);
    VertexUpdate update;
    while (tidy.step(workspace, {}, update) == Progress::running)
      ASSERT_TRUE(test::is_valid(workspace.mesh));
    EXPECT_TRUE(test::is_valid(workspace.mesh));
    added += workspace.mesh.vertex_count() - kept;
    original += kept;
  }
  EXPECT_LE(added, 0.2 * original) << "of " << original;
}

}  // namespace
}  // namespace foldless
