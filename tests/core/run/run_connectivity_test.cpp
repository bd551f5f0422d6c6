// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "core/run/run.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

using test::finish;
using test::grid_problem;
using test::placed;
using test::Script;
using test::starter_of;

TEST(RunConnectivity, ShowsWhereVerticesOfSplitsHaveMovedToAtRest) {
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int k) {
    if (k == 1) mesh.split_edge(*mesh.find_edge(5, 10), 0.5);
    if (k == 2)
      mesh.move_vertex(16, mesh.rest().col(5) * 0.75 + mesh.rest().col(10) * 0.25,
                       mesh.deformed().col(16));
  };
  foldless::Run run(grid_problem(4, Vec2(3, 3)), 0, starter_of(script));
  run.step({});
  EXPECT_EQ(run.snapshot()->rest->col(16), Vec2(1.5, 1.5));
  const auto split = run.snapshot();
  run.step({});
  EXPECT_EQ(run.snapshot()->rest->col(16), Vec2(1.25, 1.25));
  EXPECT_NE(run.snapshot()->revision, split->revision);
  EXPECT_EQ(split->rest->col(16), Vec2(1.5, 1.5)) << "what was shown stays as it was";
}

TEST(RunConnectivity, MarksFlippedEdgesUntilTheyAreFlippedBack) {
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int) {
    const auto edge = mesh.find_edge(5, 10);
    mesh.flip(edge ? *edge : *mesh.find_edge(6, 9));
  };
  foldless::Run run(grid_problem(4, Vec2(3, 3)), 0, starter_of(script));
  run.step({});
  EXPECT_EQ(*run.snapshot()->flipped_edges, (std::vector<Edge>{{6, 9}}));
  const auto flipped = run.snapshot();
  run.step({});
  EXPECT_TRUE(run.snapshot()->flipped_edges->empty());
  EXPECT_NE(run.snapshot()->revision, flipped->revision);
}

TEST(RunConnectivity, SplitsAddVerticesButNoFlippedEdges) {
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int k) {
    if (k == 1) mesh.split_edge(*mesh.find_edge(5, 10), 0.25);
  };
  const Problem problem = placed(grid_problem(4, Vec2(3, 3)), 1.7, Vec2(3, 4));
  foldless::Run run(problem, 0, starter_of(script));
  run.step({});
  const Snapshot& now = *run.snapshot();
  EXPECT_EQ(now.original_vertices, 16);
  ASSERT_EQ(now.rest->cols(), 17);
  EXPECT_EQ(now.rest->leftCols(16), problem.mesh.rest());
  EXPECT_TRUE(now.flipped_edges->empty());
}

TEST(RunConnectivity, FollowsAMeshThatLosesVerticesOfSplits) {
  Problem problem = placed(grid_problem(5, Vec2(4.5, 5)), 1.7, Vec2(3, 4));
  problem.original = OriginalMesh{std::make_shared<const Triangles>(problem.mesh.triangles()),
                                  problem.mesh.vertex_count()};
  const Points rest = problem.mesh.rest();
  for (int e = 0; e < 6; ++e) problem.mesh.split_edge(e, 0.5);
  problem.parameters.method = "foldless";
  foldless::Run run(problem);
  EXPECT_EQ(run.snapshot()->rest->cols(), 31);
  const std::vector<Iteration> records = finish(run);
  const Snapshot& now = *run.snapshot();
  ASSERT_LT(now.rest->cols(), 31);
  EXPECT_EQ(now.rest->cols(), now.deformed.cols());
  EXPECT_EQ(now.rest->leftCols(25), rest);
  EXPECT_EQ(now.original_vertices, 25);
  EXPECT_TRUE(is_injective(*now.triangles, *now.rest, now.deformed));
  EXPECT_TRUE(run.is_satisfied());
  EXPECT_NEAR(records.back().max_conformal_distortion,
              quality_of(*now.triangles, *now.rest, now.deformed).max_conformal_distortion, 1e-9);
  EXPECT_EQ(run.resumed().mesh.vertex_count(), now.rest->cols());
}

TEST(RunConnectivity, ResumedProblemsRememberTheOriginalMesh) {
  Problem problem = grid_problem(6, Vec2(2.5, 2.2));
  problem.energy = find_density("lscm");
  foldless::Run run(problem);
  finish(run);
  ASSERT_GT(run.snapshot()->flipped_edges->size(), 0U);
  const foldless::Run again(run.resumed());
  EXPECT_EQ(*again.snapshot()->flipped_edges, *run.snapshot()->flipped_edges);
  EXPECT_EQ(again.snapshot()->deformed, run.snapshot()->deformed);
  EXPECT_EQ(again.snapshot()->handles, run.snapshot()->handles);
  EXPECT_NE(again.snapshot()->revision, problem.mesh.revision());
}

}  // namespace
}  // namespace foldless
