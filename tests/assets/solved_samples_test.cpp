// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples promise to show when they are solved.
#include <gtest/gtest.h>

#include <algorithm>

#include "assets/make/sample_meshes.h"
#include "assets/make/sample_scenes.h"
#include "core/run/run.h"

namespace foldless {
namespace {

/// How a sample ended under one method.
struct Ending {
  bool satisfied = false;
  std::optional<Outcome> outcome;
  Iteration last;
};

Ending solved(const std::string& name, const std::string& method) {
  const auto all = samples::sample_scenes(samples::sample_meshes());
  const Scene& scene = std::find_if(all.begin(), all.end(), [&](const samples::SampleScene& s) {
                         return s.name == name;
                       })->scene;
  Problem problem{MeshPair(scene.triangles, scene.rest), scene.energy, scene.handles,
                  scene.parameters};
  problem.parameters.method = method;
  Run run(problem);
  Ending ending;
  while (const auto iteration = run.step({})) ending.last = *iteration;
  ending.satisfied = run.is_satisfied();
  ending.outcome = run.outcome();
  return ending;
}

TEST(SolvedSamples, ABlockedVertexPassesOnlyWhenItsEdgeFlips) {
  EXPECT_TRUE(solved("figure1_blocked_edge", "paper-flip").satisfied);
  EXPECT_FALSE(solved("figure1_blocked_edge", "paper-noflip").satisfied);
}

TEST(SolvedSamples, FlipsSaveFactorizationsOnTheCoarseDisk) {
  const Ending with = solved("figure5_coarse_disk", "paper-flip");
  const Ending without = solved("figure5_coarse_disk", "paper-noflip");
  EXPECT_TRUE(with.satisfied && without.satisfied);
  EXPECT_EQ(with.outcome, Outcome::gradient);
  EXPECT_LT(with.last.factorizations, without.last.factorizations);
}

TEST(SolvedSamples, TheGridsOfFigure11AreReachedWithFlipsOnly) {
  for (const std::string name : {"figure11_dense_grid", "figure11_coarse_grid"}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(solved(name, "paper-flip").satisfied);
    EXPECT_FALSE(solved(name, "paper-noflip").satisfied);
    EXPECT_FALSE(solved(name, "lim").satisfied);
  }
}

TEST(SolvedSamples, Figure12NeedsSplits) {
  EXPECT_FALSE(solved("figure12_splits", "paper-flip").satisfied);
  const Ending whole = solved("figure12_splits", "paper");
  EXPECT_TRUE(whole.satisfied);
  EXPECT_GT(whole.last.splits, 0);
}

TEST(SolvedSamples, TheHalfTurnIsReachedWithFlips) {
  EXPECT_TRUE(solved("swirl_180", "paper-flip").satisfied);
}

}  // namespace
}  // namespace foldless
