// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/bounded_conformal.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/mesh/quality.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::pulled_grid;
using test::run_to_its_end;

Problem with(Problem problem, StartFrames start, double K) {
  problem.parameters.start = start;
  problem.parameters.distortion_bound = K;
  return problem;
}

void expect_bounded_map(const Method& method, const Constraints& constraints, double K) {
  const MeshPair& mesh = method.mesh();
  EXPECT_TRUE(is_injective(mesh.triangles(), mesh.deformed()));
  const Quality quality = quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
  EXPECT_LE(quality.max_conformal_distortion, K * (1 + 1e-4));
  const double diagonal = bounding_box_diagonal(mesh.rest());
  for (int i = 0; i < constraints.count(); ++i)
    EXPECT_LT((mesh.deformed().col(constraints.vertices[static_cast<std::size_t>(i)]) -
               constraints.targets.col(i))
                  .norm(),
              1e-6 * diagonal);
}

TEST(BoundedConformal, MeetsTheHandlesWithinTheBoundFromEveryStart) {
  for (const std::string_view energy : {"dirichlet", "lscm", "arap"})
    for (const auto start :
         {StartFrames::rest, StartFrames::unconstrained, StartFrames::continuation}) {
      SCOPED_TRACE(testing::Message() << energy << ' ' << static_cast<int>(start));
      const Problem problem = with(pulled_grid(energy, Vec2(0.1, 0.15)), start, 3);
      BoundedConformal method(problem);
      const Iteration last = run_to_its_end(method);
      EXPECT_EQ(method.outcome(), Outcome::step);
      EXPECT_EQ(method.verdict(), "");
      expect_bounded_map(method, constraints_of(problem.handles), 3);
      EXPECT_EQ(last.penalty_energy, 0);
      EXPECT_EQ(last.flips, 0);
    }
}

TEST(BoundedConformal, ContinuationTurnsFartherThanGivenFramesWhichAreProvedInfeasible) {
  const Problem disk = test::turned_disk({.degrees = 120});
  for (const auto start : {StartFrames::rest, StartFrames::unconstrained}) {
    BoundedConformal method(with(disk, start, 60));
    run_to_its_end(method);
    EXPECT_EQ(method.outcome(), Outcome::infeasible);
    EXPECT_EQ(method.verdict(), "infeasible for these frames (certificate)");
    EXPECT_EQ(method.mesh().deformed(), disk.mesh.rest());
  }
  BoundedConformal method(with(disk, StartFrames::continuation, 60));
  run_to_its_end(method);
  EXPECT_EQ(method.outcome(), Outcome::step);
  expect_bounded_map(method, constraints_of(disk.handles), 60);
}

TEST(BoundedConformal, EveryMapOfTheContinuationIsInjectiveAndImprovingNeverRaisesTheEnergy) {
  BoundedConformal method(with(test::turned_disk({.degrees = 100}), StartFrames::continuation, 20));
  const double satisfied = kSatisfied * 0.49;
  double energy = std::numeric_limits<double>::infinity();
  int improvements = 0;
  while (const auto now = method.step({})) {
    ASSERT_TRUE(is_injective(method.mesh().triangles(), method.mesh().deformed()));
    if (now->handle_error_squared > satisfied) continue;
    EXPECT_LE(now->energy, energy);
    energy = now->energy;
    ++improvements;
  }
  EXPECT_GT(improvements, 1);
}

TEST(BoundedConformal, AHalfTurnIsReachedAlongASimilarity) {
  // Straight lines of a ring that is turned by 180° meet in a point.
  const Problem disk = test::turned_disk({.ring = 4, .degrees = 180});
  BoundedConformal method(with(disk, StartFrames::continuation, 200));
  run_to_its_end(method);
  EXPECT_EQ(method.outcome(), Outcome::step);
  expect_bounded_map(method, constraints_of(disk.handles), 200);
}

TEST(BoundedConformal, WhatIsOutOfReachEndsWithHowFarItCame) {
  BoundedConformal method(with(pulled_grid("arap", Vec2(-2, -2)), StartFrames::continuation, 2));
  run_to_its_end(method);
  ASSERT_TRUE(method.outcome());
  EXPECT_TRUE(method.outcome() == Outcome::infeasible ||
              method.outcome() == Outcome::not_converged);
  EXPECT_NE(method.verdict().find(" beyond lambda 0."), std::string::npos) << method.verdict();
  EXPECT_TRUE(is_injective(method.mesh().triangles(), method.mesh().deformed()));
}

TEST(BoundedConformal, AFoldedTriangleOfThreeHandlesIsFoundBeforeAnySolve) {
  Problem problem = pulled_grid("arap", Vec2::Zero());
  // Triangle (0, 1, 8) of the grid, turned over.
  problem.handles = {test::held(problem.mesh.rest(), 0), test::held(problem.mesh.rest(), 1),
                     test::held(problem.mesh.rest(), 8)};
  std::swap(problem.handles[1].target, problem.handles[2].target);
  BoundedConformal method(problem);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_NE(method.verdict().find("a triangle of three handles is folded"), std::string::npos);
  EXPECT_FALSE(method.step({}));
}

TEST(BoundedConformal, RefusesWhatIsNoConeProgram) {
  EXPECT_EQ(
      test::error_of([] { BoundedConformal(pulled_grid("green-strain", Vec2::Zero())); }),
      "method 'bounded-conformal' has no energy 'green-strain'; choose dirichlet, lscm or arap");
  Problem floating = pulled_grid("lscm", Vec2::Zero());
  floating.handles.resize(1);
  EXPECT_EQ(test::error_of([&] { BoundedConformal method(floating); }),
            "with the energy lscm, method 'bounded-conformal' needs two handles on every part of "
            "the mesh; the part of vertex 0 has one");
}

TEST(BoundedConformal, SoftHandlesPullWithoutBeingMet) {
  Problem problem = pulled_grid("dirichlet", Vec2::Zero());
  const Vec2 rest = problem.mesh.rest().col(24);
  const Vec2 target = rest + Vec2(0.05, 0);
  problem.handles.push_back({4, 24, target, HandleKind::soft, 1e-8});
  BoundedConformal method(problem);
  run_to_its_end(method);
  const Vec2 now = method.mesh().deformed().col(24);
  EXPECT_GT(now.x() - rest.x(), 0.001);
  EXPECT_GT((now - target).norm(), 0.001);
}

TEST(BoundedConformal, ACancelledStepChangesNothingAndMovedTargetsBeginFromTheMap) {
  Problem problem = pulled_grid("arap", Vec2(0.1, 0.1));
  BoundedConformal method(problem);
  ASSERT_TRUE(method.step({}));
  const Points before = method.mesh().deformed();
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(method.step(source.get_token()));
  EXPECT_EQ(method.mesh().deformed(), before);
  run_to_its_end(method);
  problem.handles[3].target += Vec2(0, 0.1);
  const Constraints constraints = constraints_of(problem.handles);
  const Points reached = method.mesh().deformed();
  method.set_targets(constraints.targets);
  EXPECT_FALSE(method.outcome());
  EXPECT_EQ(method.mesh().deformed(), reached);
  run_to_its_end(method);
  expect_bounded_map(method, constraints, 100);
}

}  // namespace
}  // namespace foldless
