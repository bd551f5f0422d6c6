// SPDX-License-Identifier: GPL-3.0-or-later
// What a run makes of the vertices of splits, earlier ones and its own.
#include <gtest/gtest.h>

#include "core/method/foldless/foldless.h"
#include "tests/core/method/foldless/foldless_scenes.h"

namespace foldless {
namespace {

using test::expect_on_target;
using test::run_validly;

/// The grid problem after somebody split the first edges of its mesh; handles may sit on the new
/// vertices, which begin at 81.
Problem split_grid_problem(int splits, const std::vector<std::pair<int, Vec2>>& handles) {
  const Problem before = test::grid_problem({});
  Problem problem = before;
  for (int e = 0; e < splits; ++e) problem.mesh.split_edge(e, 0.4);
  for (const auto& [vertex, move] : handles)
    problem.handles.push_back({.id = static_cast<int>(problem.handles.size()),
                               .vertex = vertex,
                               .target = problem.mesh.rest().col(vertex) + move});
  problem.original = OriginalMesh{std::make_shared<const Triangles>(before.mesh.triangles()),
                                  before.mesh.vertex_count()};
  return problem;
}

TEST(FoldlessSplits, VerticesThatNobodyNeedsGo) {
  const Problem problem = split_grid_problem(12, {{0, {0, 0}}, {80, {0.1, 0.05}}});
  ASSERT_EQ(problem.mesh.vertex_count(), 93);
  Foldless method(problem);
  run_validly(method);
  expect_on_target(method, problem);
  EXPECT_LE(method.mesh().vertex_count(), 81 + 81 / 10);
  EXPECT_EQ(method.mesh().rest().leftCols(81), problem.mesh.rest().leftCols(81));
}

TEST(FoldlessSplits, AHandleOnAVertexOfASplitKeepsItsVertex) {
  const Problem problem = split_grid_problem(12, {{0, {0, 0}}, {84, {0.1, 0.05}}});
  Foldless method(problem);
  run_validly(method);
  EXPECT_LT(method.mesh().vertex_count(), 93);
  EXPECT_EQ(method.mesh().rest().leftCols(85), problem.mesh.rest().leftCols(85));
  expect_on_target(method, problem);
}

TEST(FoldlessSplits, NewTargetsGoOnFromAMeshThatLostVertices) {
  Problem problem = split_grid_problem(12, {{0, {0, 0}}, {80, {0.1, 0.05}}});
  Foldless method(problem);
  run_validly(method);
  ASSERT_LT(method.mesh().vertex_count(), 93);
  problem.handles[1].target += Vec2(0.05, -0.1);
  method.set_targets(constraints_of(problem.handles).targets);
  run_validly(method);
  expect_on_target(method, problem);
}

}  // namespace
}  // namespace foldless
