// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the subroutines of Algorithm 1, and when its loops end: on random scenes, of which
// many cannot be reached.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/method/remeshing_assisted.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

constexpr double kSmallStep = 1e-8;  // ε_f

/// A round of a run: the updates of an inner loop, and what came before.
struct Round {
  double error_before = 0;  ///< ‖P‖²
  std::vector<Iteration> updates;
  bool has_changed_mesh = false;
  double error() const { return updates.back().handle_error_squared; }
};

/// A run to the end.
struct Course {
  double diagonal = 1;
  std::vector<Iteration> records;
  std::vector<Round> rounds;
  std::optional<Outcome> outcome;
  double error = 0;  ///< ‖P‖² of the mesh in the end

  bool is_satisfied(double squared) const { return squared <= kSatisfied * diagonal * diagonal; }
  bool is_small(const Iteration& record) const {
    return record.step_infinity_norm < kSmallStep * diagonal;
  }
};

Course course_of(const Problem& problem, Remeshing remeshing) {
  Course course;
  course.diagonal = bounding_box_diagonal(problem.mesh.rest());
  RemeshingAssisted method(problem, remeshing);
  const Constraints constraints = constraints_of(problem.handles);
  const auto error = [&] { return handle_error_squared(constraints, method.mesh().deformed()); };
  double before = error();
  int flips = 0;
  while (const auto record = method.step({})) {
    course.records.push_back(*record);
    if (record->phase == Phase::update && record->inner == 1)
      course.rounds.emplace_back().error_before = before;
    Round& round = course.rounds.back();
    if (record->phase == Phase::update) round.updates.push_back(*record);
    round.has_changed_mesh |= !course.is_small(*record) || record->flips > flips;
    flips = record->flips;
    before = error();
  }
  course.outcome = method.outcome();
  course.error = error();
  return course;
}

Problem random_problem(std::uint64_t seed, int most_inner, int most_outer) {
  Problem problem = test::random_problem(seed);
  problem.parameters.inner_iterations = most_inner;
  problem.parameters.outer_iterations = most_outer;
  return problem;
}

/// Handles that trade places: most cannot be reached.
Problem crowded(std::uint64_t seed, int most_inner, int most_outer) {
  Problem problem = test::trading_places(seed);
  problem.parameters.inner_iterations = most_inner;
  problem.parameters.outer_iterations = most_outer;
  return problem;
}

TEST(Algorithm1, FlipsAfterEveryUpdateAndNeverElse) {
  int updates = 0, updates_with_flips = 0, flips = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = random_problem(seed, 40, 1);
    const FlipSettings settings{energy_settings(problem), problem.parameters.eta, true};
    RemeshingAssisted method(problem, {.flips = true});
    std::uint64_t revision = method.mesh().revision();
    int flipped = 0;
    while (const auto record = method.step({})) {
      if (record->phase == Phase::relax) {
        EXPECT_EQ(method.mesh().revision(), revision);
      } else if (!method.outcome()) {
        MeshPair copy = method.mesh();
        left += flip_edges(copy, settings);
        updates_with_flips += record->flips > flipped;
        ++updates;
      }
      revision = method.mesh().revision();
      flipped = record->flips;
    }
    flips += flipped;
  }
  // Those that a second call finds: the heap drops an edge when its neighbour is flipped.
  EXPECT_LT(5 * left, flips);
  EXPECT_GT(2 * updates_with_flips, updates);
  EXPECT_GT(flips, 100) << "the claim would be empty";
}

TEST(Algorithm1, RelaxesAfterEveryUpdateUntilTheHessianIsPositiveDefinite) {
  int relaxations = 0, several = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Course course = course_of(random_problem(seed, 40, 1), {.flips = true});
    const std::vector<Iteration>& records = course.records;
    for (std::size_t i = 1; i < records.size(); ++i) {
      const bool was_relaxed = records[i - 1].phase == Phase::relax;
      if (records[i].phase == Phase::relax) {
        EXPECT_GT(records[i].mu, 0) << "it was not positive definite";
        EXPECT_EQ(records[i].inner, records[i - 1].inner);
        ++relaxations;
        several += was_relaxed;
      } else if (!was_relaxed || !course.is_small(records[i - 1])) {
        EXPECT_EQ(records[i].mu, 0) << "update " << records[i].inner;
        EXPECT_EQ(records[i].inner, records[i - 1].inner + 1);
      }
    }
  }
  EXPECT_GT(relaxations, 100) << "the claim would be empty";
  EXPECT_GT(several, 20);
}

TEST(Algorithm1, AnUpdateAfterAPositiveDefiniteHessianHasItsFactor) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Course course = course_of(random_problem(seed, 40, 1), {.flips = true});
    for (std::size_t i = 1; i < course.records.size(); ++i) {
      const Iteration &now = course.records[i], &before = course.records[i - 1];
      if (now.phase == Phase::update && before.phase == Phase::update &&
          i + 1 < course.records.size() && course.records[i + 1].phase == Phase::update) {
        EXPECT_EQ(now.factorizations, before.factorizations + 1) << "that of the relaxation after";
      }
    }
  }
}

TEST(Algorithm1, EndsByEquation7BeforeEquation8AndNoEarlierThanEither) {
  std::vector<Outcome> outcomes;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Problem problem = random_problem(seed, 200, 1);
    if (seed % 4 == 0) problem.parameters.gradient_tolerance = 1e-300;
    const Course course = course_of(problem, {.flips = seed % 2 == 0});
    const double tolerance =
        problem.parameters.gradient_tolerance * course.diagonal * course.diagonal;
    for (const Iteration& update : course.rounds[0].updates) {
      const bool is_last = &update == &course.rounds[0].updates.back();
      if (!is_last) {
        EXPECT_FALSE(course.is_small(update)) << update.inner;
      }
    }
    const Iteration& last = course.records.back();
    EXPECT_EQ(last.phase, Phase::update);
    const Outcome expected = last.gradient_norm_squared < tolerance ? Outcome::gradient
                             : course.is_small(last)                ? Outcome::step
                                                                    : Outcome::iteration_limit;
    EXPECT_EQ(course.outcome, expected);
    if (expected == Outcome::iteration_limit) {
      EXPECT_EQ(last.inner, 200);
    }
    outcomes.push_back(expected);
  }
  EXPECT_GE(std::ranges::count(outcomes, Outcome::gradient), 5);
  EXPECT_GE(std::ranges::count(outcomes, Outcome::step), 3);
}

TEST(Algorithm1, DoesSoManyUpdatesARoundAndSoManyRounds) {
  const Course course = course_of(crowded(2, 2, 3), {.flips = true});
  EXPECT_EQ(course.outcome, Outcome::iteration_limit);
  ASSERT_EQ(course.rounds.size(), 3U);
  for (std::size_t outer = 0; outer < 3; ++outer) {
    const std::vector<Iteration>& updates = course.rounds[outer].updates;
    ASSERT_EQ(updates.size(), 2U);
    for (std::size_t inner = 0; inner < 2; ++inner) {
      EXPECT_EQ(updates[inner].outer, static_cast<int>(outer));
      EXPECT_EQ(updates[inner].inner, static_cast<int>(inner) + 1);
    }
  }
}

TEST(Algorithm1, WithoutSplitsAnotherRoundBeginsWhereTheLastOneCouldHaveGoneOn) {
  int more_rounds = 0, ends_by_limit = 0, ends_by_step = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Course course =
        course_of(crowded(seed, seed % 3 == 0 ? 200 : 12, 8), {.flips = seed % 2 == 0});
    for (std::size_t i = 0; i < course.rounds.size(); ++i) {
      const Round& round = course.rounds[i];
      const bool is_last = i + 1 == course.rounds.size();
      const bool is_small = course.is_small(round.updates.back());
      const bool is_full = round.updates.size() == (seed % 3 == 0 ? 200U : 12U) && !is_small;
      const bool gained = round.error() < 0.9 * round.error_before;
      if (!is_last) {
        EXPECT_FALSE(course.is_satisfied(round.error())) << "round " << i;
        EXPECT_TRUE(is_full ? gained : is_small && round.has_changed_mesh) << "round " << i;
        ++more_rounds;
      } else if (i + 1 < 8 && !course.is_satisfied(round.error())) {
        if (course.outcome == Outcome::iteration_limit) {
          EXPECT_FALSE(gained);
          ++ends_by_limit;
        }
        if (course.outcome == Outcome::step) {
          EXPECT_FALSE(round.has_changed_mesh);
          ++ends_by_step;
        }
      }
    }
  }
  EXPECT_GT(more_rounds, 20) << "the claims would be empty";
  EXPECT_GT(ends_by_limit, 3);
  EXPECT_GT(ends_by_step, 0);
}

TEST(Algorithm1, WithSplitsEveryRoundButTheFirstBeginsWithSome) {
  int more_rounds = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Course course = course_of(crowded(seed, 60, 6), {.flips = true, .splits = true});
    for (std::size_t i = 1; i < course.rounds.size(); ++i, ++more_rounds) {
      EXPECT_FALSE(course.is_satisfied(course.rounds[i - 1].error()));
      EXPECT_GT(course.rounds[i].updates[0].splits, course.rounds[i - 1].updates.back().splits);
    }
  }
  EXPECT_GT(more_rounds, 20) << "the claim would be empty";
}

TEST(Algorithm1, RoundsOfSplitsThatGainedNothingAreUndone) {
  int undone = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    // So weak a penalty gives way where a finer mesh lowers the rest of E.
    Problem problem = crowded(seed, 30, 12);
    problem.parameters.alpha = 1;
    const Course course = course_of(problem, {.flips = true, .splits = true});
    if (course.rounds.size() < 3 || course.rounds.size() == 12U) continue;
    double best = course.rounds[0].error();
    int without_gain = 0;
    for (std::size_t i = 1; i + 1 < course.rounds.size(); ++i) {
      const double error = course.rounds[i].error();
      without_gain = error < 0.9 * best ? 0 : without_gain + 1;
      EXPECT_LE(without_gain, 1) << "round " << i;
      best = std::min(best, error);
    }
    if (course.is_satisfied(course.error)) continue;
    EXPECT_LE(course.error, best);
    undone += course.error == best;
  }
  EXPECT_GE(undone, 2) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
