// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/active_part.h"

#include <gtest/gtest.h>

#include "core/mesh/injective.h"
#include "core/run/run.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

using test::finish;

/// Three separate squares of two triangles in a row, their vertices and triangles interleaved, and
/// a vertex of no triangle in the middle of the list.
MeshPair three_squares() {
  constexpr int kUnused = 6;
  const auto vertex = [](int square, int corner) {
    const int v = 3 * corner + square;
    return v < kUnused ? v : v + 1;
  };
  Triangles triangles(3, 6);
  Points rest = Points::Constant(2, 13, 100);
  for (int square = 0; square < 3; ++square) {
    const double x = 2.0 * square;
    rest.col(vertex(square, 0)) = Vec2(x, 0);
    rest.col(vertex(square, 1)) = Vec2(x + 1, 0);
    rest.col(vertex(square, 2)) = Vec2(x + 1, 1);
    rest.col(vertex(square, 3)) = Vec2(x, 1);
    triangles.col(square) << vertex(square, 0), vertex(square, 1), vertex(square, 2);
    triangles.col(3 + square) << vertex(square, 0), vertex(square, 2), vertex(square, 3);
  }
  return {triangles, rest, Points(1.5 * rest)};
}

Problem middle_square_problem() {
  Problem problem{three_squares(), find_density("arap"), {}, {}};
  problem.handles = {{.id = 0, .vertex = 1, .target = Vec2(3, 0)},
                     {.id = 1, .vertex = 4, .target = Vec2(4.5, 0.25)}};
  return problem;
}

TEST(ActivePart, IsTheComponentsWithAHandleInTheirOrder) {
  const Problem problem = middle_square_problem();
  const Problem part = ActivePart(problem.mesh, problem.handles).of(problem);
  ASSERT_EQ(part.mesh.vertex_count(), 4);
  ASSERT_EQ(part.mesh.face_count(), 2);
  Points expected(2, 4);
  expected << 2, 3, 3, 2,  //
      0, 0, 1, 1;
  EXPECT_EQ(part.mesh.rest(), expected);
  EXPECT_EQ(part.mesh.deformed(), 1.5 * expected);
  EXPECT_EQ(part.handles[0].vertex, 0);
  EXPECT_EQ(part.handles[1].vertex, 1);
}

TEST(ActivePart, TheWholeIsTheSameAsLongAsThePartIs) {
  const Problem problem = middle_square_problem();
  const ActivePart active(problem.mesh, problem.handles);
  const MeshPair part = active.of(problem).mesh;
  EXPECT_EQ(active.whole_triangles(part.triangles(), 4), problem.mesh.triangles());
  EXPECT_EQ(active.whole_rest(part.rest()), problem.mesh.rest());
}

TEST(ActivePart, WhatIsAddedComesLastAndNothingElseMoves) {
  const Problem problem = middle_square_problem();
  const ActivePart active(problem.mesh, problem.handles);
  MeshPair part = active.of(problem).mesh;
  part.split_edge(part.find_edge(0, 2).value(), 0.5);
  const Points rest = active.whole_rest(part.rest());
  ASSERT_EQ(rest.cols(), 14);
  EXPECT_EQ(rest.leftCols(13), problem.mesh.rest());
  EXPECT_EQ(rest.col(13), Vec2(2.5, 0.5));
  const Triangles triangles = active.whole_triangles(part.triangles(), part.vertex_count());
  ASSERT_EQ(triangles.cols(), 8);
  for (const int idle : {0, 2, 3, 5})
    EXPECT_EQ(triangles.col(idle), problem.mesh.triangles().col(idle));
  EXPECT_TRUE(is_injective(triangles, rest));
}

TEST(ActivePart, WhereThePartLosesVerticesLaterOnesMoveUp) {
  // Two squares; in the first one a split vertex that comes before those of the second.
  Problem problem = middle_square_problem();
  MeshPair& mesh = problem.mesh;
  mesh.split_edge(mesh.find_edge(1, 8).value(), 0.5);  // vertex 13, of the middle square
  mesh.split_edge(mesh.find_edge(0, 7).value(), 0.5);  // vertex 14, of the first square
  const Points rest = mesh.rest();
  const ActivePart active(mesh, problem.handles);
  const MeshPair original =
      ActivePart(three_squares(), problem.handles).of(middle_square_problem()).mesh;
  const Points whole = active.whole_rest(original.rest());
  ASSERT_EQ(whole.cols(), 14);
  EXPECT_EQ(whole.leftCols(13), rest.leftCols(13));
  EXPECT_EQ(whole.col(13), rest.col(14));
  const Triangles triangles = active.whole_triangles(original.triangles(), 4);
  EXPECT_TRUE(is_injective(triangles, whole));
  EXPECT_EQ(triangles.cols(), 8);
}

TEST(ActivePart, IdleThingsKeepTheirPlacesBitForBitInEverySnapshot) {
  for (const std::string method : {"foldless", "paper", "lim", "bounded-conformal"}) {
    SCOPED_TRACE(method);
    Problem problem = middle_square_problem();
    problem.parameters.method = method;
    const Points before = problem.mesh.deformed();
    foldless::Run run(problem);
    EXPECT_EQ(run.snapshot()->deformed, before);
    while (run.step({})) {
      const Points& now = run.snapshot()->deformed;
      for (const int idle : {0, 2, 3, 5, 6, 7, 9, 10, 12})
        ASSERT_EQ(now.col(idle), before.col(idle)) << "vertex " << idle;
    }
    EXPECT_TRUE(run.is_satisfied());
  }
}

TEST(ActivePart, WithoutAHandleTheRunHasEndedBeforeItBegan) {
  Problem problem = middle_square_problem();
  problem.handles.clear();
  foldless::Run run(problem);
  EXPECT_EQ(run.outcome(), Outcome::gradient);
  EXPECT_FALSE(run.step({}));
  EXPECT_EQ(run.snapshot()->deformed, problem.mesh.deformed());
  run.set_targets(Points(2, 0));
  EXPECT_EQ(run.resumed().mesh.deformed(), problem.mesh.deformed());
}

TEST(ActivePart, AFoldedIdlePartIsRefusedLikeAnyOther) {
  Problem problem = middle_square_problem();
  Points deformed = problem.mesh.deformed();
  deformed.col(0) = Vec2(5, 5);  // a corner of the first square, which has no handle
  problem.mesh.set_deformed(deformed);
  EXPECT_ANY_THROW(foldless::Run{problem});
}

TEST(ActivePart, ToleranceIsInUnitsOfWhatMoves) {
  // A vertex far away must not make a handle that is 0.1 off count as satisfied.
  Problem problem = middle_square_problem();
  Points rest = problem.mesh.rest(), deformed = problem.mesh.deformed();
  rest.col(6) = deformed.col(6) = Vec2(1e9, 1e9);
  problem.mesh.set_positions(rest, deformed);
  problem.handles[1].target += Vec2(0.1, 0);
  const foldless::Run run(problem);
  EXPECT_FALSE(run.is_satisfied());
  EXPECT_DOUBLE_EQ(active_diagonal(problem.mesh.triangles(), rest, problem.handles), std::sqrt(2));
}

}  // namespace
}  // namespace foldless
