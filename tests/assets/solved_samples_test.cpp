// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples promise to show when they are solved.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/assets/solved_sample.h"

namespace foldless::test {
namespace {

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

/// What a sequence of published meshes looks like.
struct Sequence {
  double largest_jump = 0;  ///< of a vertex from one mesh to the next [length]
  int folded_meshes = 0;
};

Sequence sequence_of(const std::string& name, const std::string& method) {
  Run run(sample(name, method));
  Sequence sequence;
  Points before = run.snapshot()->deformed;
  while (run.step({})) {
    const Snapshot& now = *run.snapshot();
    sequence.largest_jump =
        std::max(sequence.largest_jump, (now.deformed - before).colwise().norm().maxCoeff());
    sequence.folded_meshes += now.folded_triangles > 0;
    before = now.deformed;
  }
  return sequence;
}

TEST(SolvedSamples,
     TheSequenceIsSmoothWhereThatOfInjectiveProjectionIsAbruptAndFolds) {  // Figure 7
  const Sequence ours = sequence_of("figure5_coarse_disk", "paper-flip");
  const Sequence theirs = sequence_of("figure5_coarse_disk", "injective-projection");
  EXPECT_EQ(ours.folded_meshes, 0);
  EXPECT_GT(theirs.folded_meshes, 0);
  EXPECT_LT(ours.largest_jump, theirs.largest_jump);
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

TEST(SolvedSamples, FoldlessReachesWhatTheOthersDoNotExactly) {
  for (const std::string name :
       {"figure1_blocked_edge", "figure11_coarse_grid", "figure12_splits"}) {
    SCOPED_TRACE(name);
    const Ending ending = solved(name, "foldless");
    EXPECT_TRUE(ending.satisfied);
    EXPECT_LE(ending.last.handle_error_squared, 1e-28);
  }
}

TEST(SolvedSamples, TheHalfTurnIsReachedWithFlips) {
  EXPECT_TRUE(solved("swirl_180", "paper-flip").satisfied);
}

}  // namespace
}  // namespace foldless::test
