// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/go_back.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/core/method/foldless/foldless_scenes.h"

namespace foldless {
namespace {

constexpr int kDragged = 40;
constexpr int kPositionsOfADrag = 20;

/// A held grid, whose middle is dragged.
Problem dragged_grid() { return test::held_grid({{kDragged, {0, 0}}}); }

Points targets_with(const Problem& problem, const Vec2& move) {
  Points targets(2, static_cast<Eigen::Index>(problem.handles.size()));
  for (Eigen::Index i = 0; i < targets.cols(); ++i)
    targets.col(i) = problem.handles[static_cast<std::size_t>(i)].target;
  targets.col(0) += move;
  return targets;
}

void go_on_to_rest(Foldless& method) {
  while (method.step({})) ASSERT_TRUE(test::is_valid(method.mesh()));
  ASSERT_EQ(method.outcome(), Outcome::gradient);
}

/// Moves the first handle, two steps of the method a position.
void drag_by_hand(Foldless& method, const Problem& problem, const Vec2& from, const Vec2& to) {
  for (int i = 1; i <= kPositionsOfADrag; ++i) {
    method.set_targets(targets_with(problem, from + (to - from) * i / kPositionsOfADrag));
    for (int step = 0; step < 2; ++step) method.step({});
  }
}

int flipped_edges(const Foldless& method, const Problem& problem) {
  const MeshPair& mesh = method.mesh();
  int flipped = 0;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge(e);
    if (b < problem.mesh.vertex_count() && !problem.mesh.find_edge(a, b)) ++flipped;
  }
  return flipped;
}

TEST(GoBack, AHandleThatIsDraggedAwayAndBackGivesTheMeshBack) {
  const Problem problem = dragged_grid();
  int flipped_on_the_way = 0;
  for (const Vec2& way :
       {Vec2(0.3, 0.02), Vec2(-0.28, 0.13), Vec2(0.05, 0.31), Vec2(-0.2, -0.25)}) {
    SCOPED_TRACE(testing::Message() << "by " << way.transpose());
    Foldless method(problem);
    go_on_to_rest(method);
    drag_by_hand(method, problem, Vec2(0, 0), way);
    go_on_to_rest(method);
    if (flipped_edges(method, problem) > 0) ++flipped_on_the_way;
    drag_by_hand(method, problem, way, Vec2(0, 0));
    go_on_to_rest(method);
    EXPECT_EQ(method.mesh().triangles(), problem.mesh.triangles());
    EXPECT_LT((method.mesh().deformed() - problem.mesh.rest()).cwiseAbs().maxCoeff(), 1e-6);
  }
  EXPECT_GE(flipped_on_the_way, 3) << "the claim would be empty";
}

TEST(GoBack, TheWayOfTheHandLeavesNoMoreEdgesFlippedThanItsEndNeeds) {
  const Problem problem = dragged_grid();
  const Vec2 far(0.3, 0.1), end(0.06, 0.02);
  Foldless fresh(problem);
  go_on_to_rest(fresh);
  fresh.set_targets(targets_with(problem, end));
  go_on_to_rest(fresh);
  Foldless dragged(problem);
  go_on_to_rest(dragged);
  drag_by_hand(dragged, problem, Vec2(0, 0), far);
  drag_by_hand(dragged, problem, far, end);
  go_on_to_rest(dragged);
  EXPECT_EQ(flipped_edges(dragged, problem), flipped_edges(fresh, problem));
  EXPECT_LT((dragged.mesh().deformed() - fresh.mesh().deformed()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(GoBack, StaysWhereTheOriginalTrianglesWouldFold) {
  const Problem problem = dragged_grid();
  Foldless method(problem);
  go_on_to_rest(method);
  drag_by_hand(method, problem, Vec2(0, 0), Vec2(0.3, 0.02));
  go_on_to_rest(method);
  EXPECT_GT(flipped_edges(method, problem), 0);
  EXPECT_EQ(method.mesh().deformed().col(kDragged), targets_with(problem, Vec2(0.3, 0.02)).col(0));
}

TEST(GoBack, OriginalTrianglesHaveTheVerticesThatHandlesNeedWhereTheyAreAtRest) {
  const Problem grid = dragged_grid();
  Problem problem = grid;
  problem.original = OriginalMesh{std::make_shared<const Triangles>(grid.mesh.triangles()), 81};
  const int in_triangle = problem.mesh.split_triangle(10, {0.2, 0.3, 0.5});
  const int on_edge = problem.mesh.split_edge(problem.mesh.find_edge(kDragged, 41).value(), 0.3);
  EXPECT_EQ(original_triangles(problem, 81), grid.mesh.triangles());
  const auto triangles = original_triangles(problem, 83);
  ASSERT_TRUE(triangles);
  const MeshPair mesh(*triangles, problem.mesh.rest());
  EXPECT_TRUE(test::is_valid(mesh));
  EXPECT_EQ(mesh.triangles_of_vertex(in_triangle).size(), 3U);
  EXPECT_EQ(mesh.triangles_of_vertex(on_edge).size(), 4U);
  EXPECT_FALSE(original_triangles(grid, 80)) << "of a mesh that is none of a part";
}

}  // namespace
}  // namespace foldless
