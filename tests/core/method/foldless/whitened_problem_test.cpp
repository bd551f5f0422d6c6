// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/whitened_problem.h"

#include <gtest/gtest.h>

#include "core/method/satisfied.h"
#include "tests/core/method/foldless/foldless_scenes.h"

namespace foldless {
namespace {

/// The problem with both planes under a linear map, and a diagonal of 1 as runs have it.
Problem under(Mat2 map, const Problem& problem) {
  map /= bounding_box_diagonal(map * problem.mesh.rest());
  Problem mapped = problem;
  mapped.mesh =
      MeshPair(problem.mesh.triangles(), map * problem.mesh.rest(), map * problem.mesh.deformed());
  for (Handle& handle : mapped.handles) handle.target = map * handle.target;
  return mapped;
}

Mat2 stretch(double factor) {
  Mat2 map;
  map << factor, 3, 0, 1;
  return map;
}

/// Handles that change places within the held boundary of a grid, which turns nothing inside out
/// that flips could not mend.
Problem handles_that_trade_places() {
  return test::held_grid({{30, {0.2, 0.2}}, {50, {-0.2, -0.2}}});
}

TEST(WhitenedProblem, SeesAStretchedSquareAsASquareAgain) {
  const Problem square = test::held_grid({{40, {0.05, 0.02}}});
  const auto whitened = whitened_problem(under(stretch(300), square));
  ASSERT_TRUE(whitened);
  const Points& rest = whitened->problem.mesh.rest();
  EXPECT_NEAR(bounding_box_diagonal(rest), 1, 1e-9);
  // A square in some orientation: neighbours of the middle are as far and at right angles.
  const Vec2 right = rest.col(41) - rest.col(40), up = rest.col(49) - rest.col(40);
  EXPECT_NEAR(right.norm() / up.norm(), 1, 1e-9);
  EXPECT_NEAR(right.dot(up) / up.squaredNorm(), 0, 1e-9);
}

TEST(WhitenedProblem, ItsTargetsGoWithItsMesh) {
  const Problem problem = under(stretch(300), test::held_grid({{40, {0.05, 0.02}}}));
  const auto whitened = whitened_problem(problem);
  ASSERT_TRUE(whitened);
  for (std::size_t i = 0; i < problem.handles.size(); ++i)
    EXPECT_LT(
        (whitened->problem.handles[i].target - whitened->map * problem.handles[i].target).norm(),
        1e-12);
}

TEST(WhitenedProblem, IsThereOnlyForMeshesThatAreTwentyTimesAsLongAsWide) {
  const Problem square = test::held_grid({{40, {0.05, 0.02}}});
  EXPECT_FALSE(whitened_problem(square));
  EXPECT_FALSE(whitened_problem(under(Vec2(19.9, 1).asDiagonal(), square)));
  EXPECT_TRUE(whitened_problem(under(Vec2(20.1, 1).asDiagonal(), square)));
  EXPECT_TRUE(whitened_problem(under(Vec2(1, 20.1).asDiagonal(), square)));
}

TEST(WhitenedProblem, ComesBackWithTheRestPositionsAndTargetsOfTheProblemBitForBit) {
  const Problem problem = under(stretch(300), test::held_grid({{40, {0.05, 0.02}}}));
  const auto whitened = whitened_problem(problem);
  ASSERT_TRUE(whitened);
  MeshPair mesh = whitened->problem.mesh;
  mesh.split_edge(mesh.find_edge(40, 41).value(), 0.5);
  const auto back = without_whitening(mesh, whitened->map, problem);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->vertex_count(), 82);
  EXPECT_EQ(back->rest().leftCols(81), problem.mesh.rest());
  for (const Handle& handle : problem.handles)
    EXPECT_EQ(back->deformed().col(handle.vertex), handle.target);
  EXPECT_TRUE(test::is_valid(*back));
}

TEST(WhitenedProblem, DoesNotComeBackFolded) {
  Problem problem = under(stretch(300), test::held_grid({{40, {0.05, 0.02}}}));
  const auto whitened = whitened_problem(problem);
  ASSERT_TRUE(whitened);
  problem.handles.front().target = problem.mesh.rest().col(0);
  EXPECT_FALSE(without_whitening(whitened->problem.mesh, whitened->map, problem));
}

TEST(FoldlessWhitened, HandlesOfAMeshOfNeedlesComeHomeAsThoseOfTheRoundOneDo) {
  for (const double factor : {100.0, 1000.0}) {
    SCOPED_TRACE(testing::Message() << "1 : " << factor);
    const Problem problem = under(stretch(factor), handles_that_trade_places());
    Foldless method(problem);
    int whitened = 0;
    while (const auto iteration = method.step({}))
      if (iteration->phase == Phase::whitened) ++whitened;
    EXPECT_EQ(method.outcome(), Outcome::gradient);
    EXPECT_GT(whitened, 0) << "the claim would be empty";
    EXPECT_TRUE(test::is_valid(method.mesh()));
  }
}

}  // namespace
}  // namespace foldless
