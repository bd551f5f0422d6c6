// SPDX-License-Identifier: GPL-3.0-or-later
// What a run makes of a boundary whose vertices are all handles.
#include <gtest/gtest.h>

#include "core/method/foldless/foldless.h"
#include "tests/core/method/foldless/foldless_scenes.h"

namespace foldless {
namespace {

using test::held_grid;
using test::run_validly;

/// True when the boundary has the vertices of the grid and no others.
bool has_boundary_of_the_grid(const MeshPair& mesh) {
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v) != (v < 81 && test::is_on_boundary_of_grid(v))) return false;
  return true;
}

TEST(FoldlessBoundary, AHandleThatIsToLeaveItIsProvedInfeasible) {
  Foldless method(held_grid({{40, {0.6, 0.05}}}));
  EXPECT_EQ(method.verdict(), "");
  run_validly(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_EQ(method.verdict(),
            "infeasible: vertex 40 is to go out of the held boundary, or onto it");
  EXPECT_TRUE(has_boundary_of_the_grid(method.mesh()));
  EXPECT_GT(method.mesh().deformed()(0, 40), 0.6) << "it is brought near";
}

TEST(FoldlessBoundary, HandlesThatAreToMeetInsideAreProvedInfeasible) {
  Problem problem = held_grid({{40, {0, 0}}, {41, {0, 0}}});
  problem.handles[1].target = problem.handles[0].target;
  Foldless method(std::move(problem));
  run_validly(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_TRUE(method.verdict().starts_with("infeasible: vertices 40 and 41 ")) << method.verdict();
}

TEST(FoldlessBoundary, NothingIsProvedWhereAVertexOfItIsFree) {
  Foldless method(held_grid({{40, {0.6, 0.05}}}, 44));
  run_validly(method);
  EXPECT_EQ(method.outcome(), Outcome::gradient) << "the boundary bends";
  EXPECT_EQ(method.verdict(), "");
}

TEST(FoldlessBoundary, TargetsThatComeBackWithinReachAreReached) {
  const Problem problem = held_grid({{40, {0.6, 0.05}}});
  Points targets = constraints_of(problem.handles).targets;
  Foldless method(problem);
  run_validly(method);
  ASSERT_EQ(method.outcome(), Outcome::infeasible);
  for (const double x : {0.9, 0.6, 0.8, 0.4}) {
    targets.col(0) = Vec2(x, 0.3);
    method.set_targets(targets);
    EXPECT_FALSE(method.outcome());
    EXPECT_EQ(method.verdict(), "");
    run_validly(method);
    ASSERT_EQ(method.outcome(), x < 0.7 ? Outcome::gradient : Outcome::infeasible) << x;
  }
  EXPECT_EQ(Vec2(method.mesh().deformed().col(40)), Vec2(0.4, 0.3));
  EXPECT_EQ(method.verdict(), "");
}

TEST(FoldlessBoundary, IsNotSplitWhereItIsHeld) {
  int splits = 0;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    if (seed % 3 == 0) continue;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(test::trading_places(seed));
    for (int step = 0; step < 400 && !method.outcome(); ++step) {
      if (const auto iteration = method.step({})) splits = std::max(splits, iteration->splits);
      ASSERT_TRUE(has_boundary_of_the_grid(method.mesh())) << "step " << step;
    }
    EXPECT_NE(method.outcome(), Outcome::infeasible) << method.verdict();
  }
  EXPECT_GT(splits, 0) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
