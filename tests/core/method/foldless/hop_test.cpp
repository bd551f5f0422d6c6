// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/hop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/mesh/generate.h"
#include "core/method/foldless/approach.h"
#include "core/method/foldless/candidates.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/tidy.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::StageRunner;

OwnWorkspace trading_workspace(std::uint64_t seed) {
  const Problem problem = test::trading_places(seed);
  RunSettings settings = test::run_settings(problem.energy, problem.mesh);
  settings.diagonal = bounding_box_diagonal(problem.mesh.rest());
  return {problem.mesh, constraints_of(problem.handles), std::move(settings)};
}

/// False where the handles do not get to their targets.
bool arrives_and_settles(OwnWorkspace& own) {
  const auto progress = test::run_to_the_end(
      within(kMostOfACandidate, own.effort, approach(own.work, FactorUse::lagged)));
  if (progress != Progress::arrived) return false;
  test::run_to_the_end(tidy(own.work));
  return true;
}

double distortion_energy(const Workspace& work) {
  return work.system.objective().value(work.held_energy(), work.mesh.deformed()).distortion;
}

TEST(Hop, IsValidWhateverIsCancelledAndEndsWithNoMoreEnergyUnlessItWasCrushed) {
  int lower = 0, cancelled = 0;
  double logarithms = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = trading_workspace(seed);
    Workspace& work = own.work;
    if (!arrives_and_settles(own)) continue;
    const double before = distortion_energy(work);
    const double most_distortion = most_distortion_beside(work.mesh);
    const bool was_crushed = is_crushed(work.mesh);
    StageRunner<void> runner(hop(work));
    int factorizations = own.effort.factorizations;
    cancelled += test::run_with_cancels(runner, seed, [&](bool was_cancelled) {
      if (was_cancelled) {
        EXPECT_EQ(own.effort.factorizations, factorizations);
      }
      factorizations = own.effort.factorizations;
      EXPECT_TRUE(test::is_valid(work.mesh));
    });
    EXPECT_EQ(work.error(), 0);
    if (!was_crushed) {
      EXPECT_LE(distortion_energy(work), before);
    }
    EXPECT_LE(largest_distortion(work.mesh), most_distortion);
    logarithms += std::log(distortion_energy(work) / before);
    if (distortion_energy(work) < 0.98 * before) ++lower;
  }
  EXPECT_GT(cancelled, 20) << "the claim would be empty";
  EXPECT_GE(lower, 3);
  EXPECT_LT(logarithms, -0.2);
}

TEST(Hop, ThatGainsLessThanAHundredthIsTheLast) {
  int last = 0, not_last = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = trading_workspace(seed);
    Workspace& work = own.work;
    if (!arrives_and_settles(own) || is_crushed(work.mesh)) continue;
    double energy = settled_energy(work);
    bool is_over = false;
    StageRunner<void> runner(hop(work));
    while (runner.step({})) {
      EXPECT_FALSE(is_over);
      const double now = settled_energy(work);  // of the last hop that found something
      if (now == energy) continue;
      is_over = now > 0.99 * energy;
      (is_over ? last : not_last) += 1;
      energy = now;
    }
  }
  EXPECT_GE(last, 3) << "the claim would be empty";
  EXPECT_GE(not_last, 3);
}

TEST(Hop, IsNotMadeOfAMeshThatWasDeformedBefore) {
  int deformed = 0;
  for (std::uint64_t seed = 1; seed <= 200 && deformed < 5; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = trading_workspace(seed);
    if (!arrives_and_settles(own) || largest_distortion(own.work.mesh) <= kHardlyDistorted ||
        largest_distortion(own.work.mesh) > 90)  // candidates would compete
      continue;
    Problem frame = test::trading_places(seed);
    frame.mesh = own.work.mesh;
    Foldless method(frame);
    const int of_frame = test::run_validly(method).back().factorizations;
    own.effort.factorizations = 0;
    test::run_to_the_end(hop(own.work));
    EXPECT_LT(2 * of_frame, own.effort.factorizations);
    ++deformed;
  }
  EXPECT_EQ(deformed, 5) << "the claim would be empty";
}

TEST(Hop, CostsNothingWhereTheMapIsHardlyDistortedOrTheMeshIsLarge) {
  const auto factorizations_of_squeezed = [](int cells, double factor) {
    const Shape shape = grid({.columns = cells, .rows = cells, .width = 1, .height = 1});
    Points u = shape.rest;
    u.row(1) /= factor;
    OwnWorkspace own = test::workspace_of(MeshPair(shape.triangles, shape.rest, u),
                                          {{.id = 0, .vertex = 0, .target = u.col(0)}});
    test::run_to_the_end(hop(own.work));
    return own.effort.factorizations;
  };
  EXPECT_EQ(factorizations_of_squeezed(6, 15), 0);
  EXPECT_GT(factorizations_of_squeezed(6, 25), 0);
  ASSERT_GT(2 * 40 * 40, kLargestWithCandidates);
  EXPECT_EQ(factorizations_of_squeezed(40, 25), 0);
}

}  // namespace
}  // namespace foldless
