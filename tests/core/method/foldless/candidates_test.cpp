// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/candidates.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/tidy.h"
#include "core/method/satisfied.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

OwnWorkspace workspace_for(const Problem& problem, const MeshPair& mesh) {
  RunSettings settings = test::run_settings(problem.energy, problem.mesh);
  settings.diagonal = bounding_box_diagonal(problem.mesh.rest());
  return {mesh, constraints_of(problem.handles), std::move(settings)};
}

TEST(Candidates, AreLeftWhenTheyHaveTakenTheirFactorizationsAndElseEndAsByThemselves) {
  int left = 0, ended = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = seed % 2 == 0 ? test::random_problem(seed) : test::trading_places(seed);
    OwnWorkspace alone = workspace_for(problem, problem.mesh),
                 bounded = workspace_for(problem, problem.mesh);
    const Progress progress = test::run_to_the_end(approach(alone.work, FactorUse::own));
    constexpr int kMost = 30;
    StageRunner<std::optional<Progress>> runner(
        within(kMost, bounded.effort, approach(bounded.work, FactorUse::own)));
    Points before = bounded.work.mesh.deformed();
    test::run_with_cancels(runner, seed, [&](bool was_cancelled) {
      if (was_cancelled) {
        EXPECT_EQ(bounded.work.mesh.deformed(), before);
      }
      before = bounded.work.mesh.deformed();
      EXPECT_TRUE(test::is_valid(bounded.work.mesh));
    });
    const std::optional<Progress> result = runner.result();
    if (alone.effort.factorizations < kMost) {
      ++ended;
      EXPECT_EQ(result, progress);
      EXPECT_EQ(bounded.work.mesh.deformed(), alone.work.mesh.deformed());
    } else {
      ++left;
      EXPECT_EQ(result, std::nullopt);
      EXPECT_GE(bounded.effort.factorizations, kMost);
      EXPECT_LE(bounded.effort.factorizations, kMost + 5) << "a step takes few";
    }
  }
  EXPECT_GT(left, 2) << "the claim would be empty";
  EXPECT_GT(ended, 2) << "the claim would be empty";
}

TEST(Candidates, NoneHasLessEnergyAndNoMoreDistortionThanAPoorShapeThatStays) {
  int poor = 0;
  for (std::uint64_t seed = 3; seed <= 240; seed += 3) {  // boundaries that are free
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::trading_places(seed);
    OwnWorkspace end = workspace_for(problem, problem.mesh);
    if (test::run_to_the_end(approach(end.work, FactorUse::lagged)) != Progress::arrived) continue;
    test::run_to_the_end(tidy(end.work));
    if (largest_distortion(end.work.mesh) <= 100) continue;
    test::run_to_the_end(try_candidates(end.work, problem.mesh));
    for (int i = 0; i < kCandidates; ++i) {
      OwnWorkspace other = workspace_for(problem, problem.mesh);
      const auto progress =
          test::run_to_the_end(within(kMostOfACandidate, other.effort, candidate(i, other.work)));
      if (progress != Progress::arrived) continue;
      ++poor;
      test::run_to_the_end(tidy(other.work));
      if (largest_distortion(other.work.mesh) > largest_distortion(end.work.mesh)) continue;
      EXPECT_FALSE(has_less_energy(other.work, end.work)) << "candidate " << i;
    }
  }
  EXPECT_GT(poor, 2) << "the claim would be empty";
}

TEST(Candidates, HaveLessEnergyByMoreThanRounding) {
  const Problem problem = test::grid_problem({{0, {0, 0}}, {8, {0, 0}}, {80, {0.1, 0.1}}});
  Foldless method(problem);
  while (method.step({})) {
  }
  const OwnWorkspace good = workspace_for(problem, method.mesh());
  MeshPair bent = method.mesh();
  Points u = bent.deformed();
  u.col(40) += Vec2(0.03, 0.01);
  bent.set_deformed(u);
  const OwnWorkspace bad = workspace_for(problem, bent);
  ASSERT_TRUE(test::is_valid(bent));
  EXPECT_TRUE(has_less_energy(good.work, bad.work));
  EXPECT_FALSE(has_less_energy(bad.work, good.work));
  EXPECT_FALSE(has_less_energy(good.work, good.work));
}

TEST(Candidates, MayBeMoreDistortedByHalfAsLongAsNothingIsCrushed) {
  const auto squeezed = [](double factor) {
    MeshPair mesh = test::grid_problem({}).mesh;
    Points u = mesh.deformed();
    u.row(1) /= factor;
    mesh.set_deformed(u);
    return mesh;
  };
  EXPECT_NEAR(most_distortion_beside(squeezed(30)), 45, 1e-9);
  EXPECT_NEAR(most_distortion_beside(squeezed(800)), 1000, 1e-9);
  EXPECT_NEAR(most_distortion_beside(squeezed(4000)), 4000, 1e-6) << "no more than it is";
}

}  // namespace
}  // namespace foldless
