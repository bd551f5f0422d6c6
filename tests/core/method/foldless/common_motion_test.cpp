// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/common_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "core/mesh/generate.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

using test::OwnWorkspace;

/// z → scale · turned by `angle` z + shift.
struct Similarity {
  double scale = 1, angle = 0;
  Vec2 shift = Vec2::Zero();

  Points operator()(const Points& z) const {
    return (scale * (Eigen::Rotation2Dd(angle).toRotationMatrix() * z)).colwise() + shift;
  }
};

Similarity random_similarity(std::mt19937_64& random, double largest_scale) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return {std::pow(largest_scale, unit(random)), 3.1 * unit(random),
          test::random_vector(unit, random)};
}

const std::vector<int> kHandles = {3, 40, 44, 75};

/// The 9 × 9 grid with handles whose targets a motion gives, moved apart by `noise`.
Problem grid_moved_by(const Similarity& motion, const std::vector<int>& vertices,
                      double noise = 0) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-noise, noise);
  Problem problem = test::grid_problem({});
  const Points targets = motion(problem.mesh.rest());
  for (const int v : vertices)
    problem.handles.push_back(
        {.id = v, .vertex = v, .target = targets.col(v) + test::random_vector(unit, random)});
  return problem;
}

bool moves(Workspace& work, CommonMotion which) {
  return test::run_to_the_end(move_together(work, which));
}

double largest_difference(const Points& a, const Points& b) {
  return (a - b).colwise().norm().maxCoeff();
}

TEST(CommonMotion, OnePinMovesItsPartByATranslationWhateverTheWay) {
  for (const double length : {1e-6, 0.01, 3.0, 1e3}) {
    SCOPED_TRACE(length);
    const Similarity motion{.shift = length * Vec2(0.6, -0.8)};
    const Problem problem = grid_moved_by(motion, {40});
    Foldless method(problem);
    test::run_validly(method);
    EXPECT_EQ(method.mesh().deformed().col(40), problem.handles[0].target);
    EXPECT_LT(largest_difference(method.mesh().deformed(), motion(problem.mesh.rest())),
              1e-12 * (1 + length));
  }
}

TEST(CommonMotion, ARigidMotionOfAllHandlesIsThatOfTheMeshInADragToo) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const Similarity motion = random_similarity(random, 1);
    const Problem problem = grid_moved_by(motion, kHandles);
    const Points expected = motion(problem.mesh.rest());
    Foldless fresh(problem);
    test::run_validly(fresh);
    test::expect_on_target(fresh, problem);
    EXPECT_LT(largest_difference(fresh.mesh().deformed(), expected), 1e-9);
    Foldless dragged(grid_moved_by({}, kHandles));
    test::run_validly(dragged);
    dragged.set_targets(constraints_of(problem.handles).targets);
    test::run_validly(dragged);
    EXPECT_LT(largest_difference(dragged.mesh().deformed(), expected), 1e-9);
  }
}

TEST(CommonMotion, ASimilarityMovesEveryVertexAndPutsTheHandlesExactlyOnTheirTargets) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const Similarity motion = random_similarity(random, 1.9);
    const Problem problem = grid_moved_by(motion, kHandles);
    OwnWorkspace own = test::workspace_of(problem);
    ASSERT_TRUE(moves(own.work, CommonMotion::exact));
    EXPECT_EQ(own.work.error(), 0);
    EXPECT_LT(largest_difference(own.work.mesh.deformed(), motion(problem.mesh.rest())), 1e-12);
    EXPECT_FALSE(moves(own.work, CommonMotion::exact)) << "nothing is left";
  }
}

TEST(CommonMotion, OnlyWhatAllHandlesDoIsExact) {
  const Problem problem = grid_moved_by({.angle = 2}, kHandles, 1e-3);
  OwnWorkspace own = test::workspace_of(problem);
  EXPECT_FALSE(moves(own.work, CommonMotion::exact));
  OwnWorkspace large = test::workspace_of(grid_moved_by({.scale = 2.1}, kHandles));
  EXPECT_FALSE(moves(large.work, CommonMotion::exact)) << "a scale beyond two";
}

TEST(CommonMotion, TheNearestRigidMotionIsTakenWhereItLeavesLessThanHalfOfALongWay) {
  const Problem problem = grid_moved_by({.angle = 2, .shift = {0.5, 0}}, kHandles, 0.05);
  OwnWorkspace own = test::workspace_of(problem);
  const double error = own.work.error();
  ASSERT_TRUE(moves(own.work, CommonMotion::near));
  EXPECT_LT(own.work.error(), 0.25 * error);
  const Points& u = own.work.mesh.deformed();
  const Points& rest = problem.mesh.rest();
  for (int v = 1; v < 81; ++v)
    EXPECT_NEAR((u.col(v) - u.col(0)).norm(), (rest.col(v) - rest.col(0)).norm(), 1e-12);

  OwnWorkspace shortly = test::workspace_of(grid_moved_by({.shift = {0.02, 0}}, kHandles, 0.001));
  EXPECT_FALSE(moves(shortly.work, CommonMotion::near)) << "a short way";
  Problem apart = grid_moved_by({}, kHandles);
  apart.handles[0].target += Vec2(0.3, 0);
  OwnWorkspace others_stay = test::workspace_of(apart);
  EXPECT_FALSE(moves(others_stay.work, CommonMotion::near)) << "the others stay";
}

TEST(CommonMotion, PartsMoveByThemselves) {
  const Shape shape = grid({.columns = 4, .rows = 4, .width = 0.3, .height = 0.3});
  const Eigen::Index n = shape.rest.cols();
  Points rest(2, 2 * n);
  rest << shape.rest, shape.rest.colwise() + Vec2(0.5, 0);
  Triangles triangles(3, 2 * shape.triangles.cols());
  triangles << shape.triangles, shape.triangles.array() + static_cast<int>(n);
  const Vec2 way(0.1, 0.2);
  const int first = 12, second = static_cast<int>(n) + 3;
  OwnWorkspace own = test::workspace_of(
      MeshPair(triangles, rest), {{.id = 0, .vertex = first, .target = rest.col(first)},
                                  {.id = 1, .vertex = second, .target = rest.col(second) + way}});
  ASSERT_TRUE(moves(own.work, CommonMotion::exact));
  EXPECT_EQ(own.work.mesh.deformed().leftCols(n), rest.leftCols(n));
  const Points moved = rest.rightCols(n).colwise() + way;
  EXPECT_LT(largest_difference(own.work.mesh.deformed().rightCols(n), moved), 1e-15);
}

TEST(CommonMotion, AMeshThatWouldLeaveTheFeasibleSetStays) {
  OwnWorkspace own = test::workspace_of(grid_moved_by({.scale = 0.6}, kHandles));
  own.settings.energy.delta = 0.5;  // areas become 0.36 of what they were
  const Points before = own.work.mesh.deformed();
  EXPECT_FALSE(moves(own.work, CommonMotion::exact));
  EXPECT_EQ(own.work.mesh.deformed(), before);
}

}  // namespace
}  // namespace foldless
