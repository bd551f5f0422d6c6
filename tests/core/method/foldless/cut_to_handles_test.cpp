// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/cut_to_handles.h"

#include <gtest/gtest.h>

#include "tests/core/method/foldless/permutations.h"
#include "tests/core/method/foldless/stage_runner.h"
#include "tests/core/method/foldless/workspaces.h"

namespace foldless {
namespace {

using test::OwnWorkspace;
using test::permutation;

TEST(CutToHandles, ArrivesWhereTwoHandlesChangePlaces) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::workspace_of(permutation(seed, 2));
    ASSERT_EQ(test::run_to_the_end(cut_to_handles(own.work, CutBoundary::held)), Progress::arrived);
    EXPECT_TRUE(test::is_valid(own.work.mesh));
    EXPECT_EQ(own.work.handles(), own.work.constraints.targets);
  }
}

TEST(CutToHandles, ArrivesInAnyPermutationOfEightAndKeepsFewOfTheVerticesThatItMade) {
  int made = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::workspace_of(permutation(seed, 8));
    const int before = own.work.mesh.vertex_count();
    ASSERT_EQ(test::run_to_the_end(cut_to_handles(own.work, CutBoundary::held)), Progress::arrived);
    EXPECT_TRUE(test::is_valid(own.work.mesh));
    EXPECT_EQ(own.work.handles(), own.work.constraints.targets);
    made += own.effort.splits;
    kept += own.work.mesh.vertex_count() - before;
  }
  EXPECT_LT(3 * kept, 2 * made) << kept << " of " << made;
}

TEST(CutToHandles, LeavesTheMeshAsItWasWhereATargetIsOutsideOfTheHeldBoundary) {
  Problem problem = permutation(1, 2);
  problem.handles.back().target = Vec2(1.2, 0);
  OwnWorkspace own = test::workspace_of(problem);
  EXPECT_EQ(test::run_to_the_end(cut_to_handles(own.work, CutBoundary::held)), Progress::locked);
  EXPECT_EQ(own.work.mesh.revision(), problem.mesh.revision());
  EXPECT_EQ(own.work.mesh.deformed(), problem.mesh.deformed());
}

TEST(CutToHandles, BringsHandlesOfAFreeBoundaryAndThoseInsideToTheirTargets) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    OwnWorkspace own = test::workspace_of(permutation(seed, 4, CutBoundary::free));
    ASSERT_EQ(test::run_to_the_end(cut_to_handles(own.work, CutBoundary::free)), Progress::arrived);
    EXPECT_TRUE(test::is_valid(own.work.mesh));
    EXPECT_EQ(own.work.handles(), own.work.constraints.targets);
  }
}

/// Two problems as one of two components, the second one far to the right.
Problem side_by_side(const Problem& left, const Problem& right) {
  const int vertices = left.mesh.vertex_count(), handles = static_cast<int>(left.handles.size());
  const Vec2 way(10, 0);
  Triangles triangles(3, left.mesh.face_count() + right.mesh.face_count());
  triangles << left.mesh.triangles(), (right.mesh.triangles().array() + vertices).matrix();
  Points rest(2, vertices + right.mesh.vertex_count());
  rest << left.mesh.rest(), right.mesh.rest().colwise() + way;
  Problem both = left;
  both.mesh = MeshPair(triangles, rest);
  for (Handle handle : right.handles) {
    handle.id += handles;
    handle.vertex += vertices;
    handle.target += way;
    both.handles.push_back(handle);
  }
  return both;
}

TEST(CutToHandles, ConstructsDisksThatAreHeldBesideAFreeBoundary) {
  const Problem held = permutation(1, 8), free = permutation(1, 4, CutBoundary::free);
  OwnWorkspace own = test::workspace_of(side_by_side(held, free));
  const MeshPair& mesh = own.work.mesh;
  const Constraints& constraints = own.work.constraints;
  EXPECT_EQ(handles_to_cut(mesh, constraints, CutBoundary::free), 4 + 15);
  const auto cut = cut_open(mesh, constraints, CutBoundary::free, 0);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(test::is_valid(*cut));
  EXPECT_EQ(Points(cut->deformed()(Eigen::all, constraints.vertices)), constraints.targets);
}

TEST(CutToHandles, IsForHeldDisksWithAHandleInsideAndForFreeBoundariesWhereOneIsOffItsTarget) {
  const auto handles = [](const Problem& problem, CutBoundary boundary) {
    return handles_to_cut(problem.mesh, constraints_of(problem.handles), boundary);
  };
  const Problem held = permutation(1, 3), partly_free = permutation(1, 3, CutBoundary::free);
  EXPECT_EQ(handles(held, CutBoundary::held), 3);
  EXPECT_EQ(handles(held, CutBoundary::free), 0);
  EXPECT_EQ(handles(partly_free, CutBoundary::held), 0);
  EXPECT_EQ(handles(partly_free, CutBoundary::free), 3 + 15);
  Problem on_target = held, without_inside = held;
  for (Handle& handle : on_target.handles) handle.target = held.mesh.rest().col(handle.vertex);
  EXPECT_EQ(handles(on_target, CutBoundary::held), 0);
  without_inside.handles.resize(without_inside.handles.size() - 3);
  without_inside.handles.front().target *= 1.1;
  EXPECT_EQ(handles(without_inside, CutBoundary::held), 0);
}

TEST(CutToHandles, ReachesWhatNothingElseDoesInARun) {
  int constructed = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = permutation(seed, 8);
    Foldless method(problem);
    const std::vector<Iteration> records = test::run_validly(method);
    test::expect_on_target(method, problem);
    if (test::phases_of(records).contains(Phase::construct)) ++constructed;
  }
  EXPECT_GT(constructed, 0) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
