// SPDX-License-Identifier: GPL-3.0-or-later
// Who comes after whom in a run of `foldless`, and from which mesh.
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "core/method/foldless/foldless.h"
#include "core/method/foldless/tidy.h"
#include "tests/core/method/foldless/coarse_scenes.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/permutations.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

using test::trading_places;

TEST(Driver, AfterALockedPursuitTheApproachBeginsFromTheMeshOfTheProblem) {
  int locked = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = trading_places(seed);
    Foldless method(problem);
    bool has_moved = false;
    std::optional<Iteration> record;
    for (int step = 0; step < 100 && (record = method.step({})); ++step) {
      if (record->phase != Phase::pursue) break;
      const bool is_at_start = method.mesh().deformed() == problem.mesh.deformed();
      if (has_moved && is_at_start) ++locked;
      has_moved |= !is_at_start;
    }
  }
  EXPECT_GE(locked, 8);
}

TEST(Driver, HandlesThatMoveTogetherAreApproachedFromThereAndThenTwiceFromTheMeshOfTheProblem) {
  const auto same = [](const Points& a, const Points& b) { return a.cols() == b.cols() && a == b; };
  int from_there = 0, twice_from_problem = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = trading_places(seed);
    for (Handle& handle : problem.handles) handle.target += Vec2(3, 1);
    Foldless method(problem);
    ASSERT_TRUE(method.step({}));
    const Points moved = method.mesh().deformed();
    EXPECT_LT((moved.rowwise().mean() - problem.mesh.rest().rowwise().mean() - Vec2(3, 1)).norm(),
              0.5);
    int from_problem = 0;
    std::optional<Iteration> record;
    for (int step = 0; step < 1000 && (record = method.step({})); ++step) {
      const Points& u = method.mesh().deformed();
      if (record->phase == Phase::pursue && same(u, moved)) ++from_there;
      if (record->phase == Phase::approach && same(u, problem.mesh.deformed())) ++from_problem;
      if (record->phase == Phase::transport) break;
    }
    EXPECT_LE(from_problem, 2) << "with lagged steps and with those of Newton himself";
    if (from_problem == 2) ++twice_from_problem;
  }
  EXPECT_GE(from_there, 8);
  EXPECT_GE(twice_from_problem, 6);
}

TEST(Driver, WhatHasArrivedStaysOnShowUntilALessCrushedMeshIsFound) {
  Foldless method(test::permutation(6, 20));
  int tried = 0;
  double settled = 0;  // its largest σ₁/σ₂; none before the first mesh has
  Phase before = Phase::pursue;
  while (const std::optional<Iteration> record = method.step({})) {
    const double now = largest_distortion(method.mesh());
    const bool begins = record->phase == Phase::construct && before != Phase::construct;
    if (settled > 0) {
      EXPECT_LE(now, 2 * settled) << "maps under construction are worse by powers of ten";
      if (begins) ++tried;
    } else if (begins && before == Phase::settle) {
      settled = now;
      ++tried;
    }
    before = record->phase;
  }
  EXPECT_GE(tried, 2) << "the claim would be empty";
}

// A hop first raises E by what makes triangles round.
TEST(Driver, AShapeThatIsDistortedIsLookedAtAgain) {
  int distorted = 0, looked_at = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Foldless method(trading_places(seed));
    double least = std::numeric_limits<double>::infinity();  // E_d while it settles
    double at_least = 0;                                     // the largest σ₁/σ₂ then
    bool rises = false;
    for (int step = 0; step < 400; ++step) {
      const std::optional<Iteration> record = method.step({});
      if (!record) break;
      if (record->phase != Phase::settle) continue;
      rises |= record->distortion_energy > 1.2 * least;
      if (record->distortion_energy >= least) continue;
      least = record->distortion_energy;
      at_least = record->max_conformal_distortion;
    }
    if (at_least < 1.5 * kHardlyDistorted || at_least > 5 * kHardlyDistorted) continue;
    ++distorted;
    looked_at += rises;
  }
  EXPECT_GE(distorted, 8) << "the claim would be empty";
  EXPECT_GE(looked_at, distorted - 1);
}

// Run brings targets and deformed meshes to the origin, but not the rest mesh.
TEST(Driver, ARunFromRestIsNoneOfADeformedMeshWhereverTheRestMeshLies) {
  int transported = 0;
  for (const std::uint64_t seed : {1, 2, 4, 5, 7, 8}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = trading_places(seed);
    problem.offset = Vec2(0.5, -0.25);
    problem.mesh.set_deformed(problem.at_rest());
    for (Handle& handle : problem.handles) handle.target += problem.offset;
    Foldless method(problem);
    std::optional<Iteration> record;
    for (int step = 0, splits = 0; step < 1000 && (record = method.step({})); ++step) {
      if (record->phase == Phase::transport) {
        ++transported;
        break;
      }
      EXPECT_LT(record->splits - splits, problem.mesh.edge_count() / 2) << "it was refined";
      splits = record->splits;
    }
  }
  EXPECT_GE(transported, 3) << "the claim would be empty";
}

TEST(Driver, AfterALockedPursuitOfADragItGoesOnFromTheMeshAsItIs) {
  int approaches = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = trading_places(seed);
    Problem at_rest = problem;
    for (Handle& handle : at_rest.handles) handle.target = at_rest.mesh.rest().col(handle.vertex);
    Foldless method(at_rest);
    test::run_validly(method);
    method.set_targets(constraints_of(problem.handles).targets);
    for (int step = 0; step < 100; ++step) {
      const auto record = method.step({});
      ASSERT_TRUE(record);
      EXPECT_NE(method.mesh().deformed(), problem.mesh.deformed());
      if (record->phase == Phase::approach) {
        ++approaches;
        break;
      }
    }
  }
  EXPECT_GE(approaches, 8) << "the claim would be empty";
}

TEST(Driver, WhereAPursuitOfATurnLocksTheApproachGoesInLegsAndArrives) {
  for (const double degrees : {170, 180, 190}) {  // straight ways lock here
    SCOPED_TRACE(degrees);
    Foldless method(test::held_grid(test::turned({20, 24, 56, 60}, degrees)));
    int approaches = 0;
    while (true) {
      const auto record = method.step({});
      ASSERT_TRUE(record);
      if (record->phase == Phase::settle) break;
      ASSERT_NE(record->phase, Phase::transport);
      ASSERT_EQ(record->splits, 0);
      if (record->phase == Phase::approach) ++approaches;
    }
    EXPECT_GT(approaches, 0) << "the claim would be empty";
    EXPECT_LT(approaches, 50);
  }
}

void expect_no_step_back(Foldless& method, int most_steps) {
  Iteration before;
  for (int step = 0; step < most_steps; ++step) {
    const auto record = method.step({});
    if (!record) break;
    EXPECT_GE(record->factorizations, before.factorizations);
    EXPECT_GE(record->updates, before.updates);
    EXPECT_GE(record->flips, before.flips);
    EXPECT_GE(record->splits, before.splits);
    EXPECT_GE(record->outer, before.outer);
    EXPECT_GE(record->seconds, before.seconds);
    EXPECT_EQ(record->inner, before.inner + 1);
    before = *record;
  }
  EXPECT_GT(before.factorizations, 0);
}

TEST(Driver, TotalsNeverGoBackWhateverIsTried) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foldless method(trading_places(seed));
    expect_no_step_back(method, 600);
  }
  Foldless dense(test::bent_bar(), test::kSmall);
  expect_no_step_back(dense, 600);
}

TEST(Driver, ASoftHandleThatCanBeMetEndsAtItsTarget) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = test::grid_problem({{0, {0, 0}}, {8, {0, 0}}, {80, {0.05, 0.1}}});
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-0.05, 0.05);
    Handle soft = test::held(problem.mesh.rest(), 40);
    soft.id = 9;
    soft.kind = HandleKind::soft;
    soft.target += test::random_vector(unit, random);
    problem.handles.push_back(soft);
    Foldless method(problem);
    test::run_validly(method);
    test::expect_on_target(method, problem);
    EXPECT_LT((method.mesh().deformed().col(40) - soft.target).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace foldless
