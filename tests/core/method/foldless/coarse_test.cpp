// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

#include "core/method/foldless/foldless.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::is_valid;

/// Small enough for tests; a coarse mesh is not coarsened again.
constexpr CoarseSettings kSmall{.dense_from = 600, .least_vertices = 200, .ratio = 4};
constexpr CoarseSettings kNever{.dense_from = std::numeric_limits<int>::max()};

MeshPair grid_mesh(int columns, int rows) {
  const Shape shape = grid({.columns = columns,
                            .rows = rows,
                            .width = 0.9,
                            .height = 0.9 * rows / columns,
                            .diagonal = Diagonal::alternating});
  return {shape.triangles, shape.rest};
}

/// A grid held at its left side, the right side turned by a quarter and lifted.
Problem bent_grid(int columns, int rows) {
  Problem problem{grid_mesh(columns, rows), find_density("arap"), {}, {}};
  const Points& rest = problem.mesh.rest();
  const Eigen::Rotation2Dd turn(std::numbers::pi / 2);
  for (int j = 0; j <= rows; ++j) {
    const int left = j * (columns + 1), right = left + columns;
    problem.handles.push_back(test::held(rest, left));
    problem.handles.push_back(test::held(rest, right));
    problem.handles.back().target = turn * (rest.col(right) - rest.col(columns)) + Vec2(0.75, 0.3);
  }
  return problem;
}

/// 915 vertices; its coarse mesh has about 228.
Problem bent_bar() { return bent_grid(60, 14); }

/// What a run to the end went through.
struct Course {
  std::vector<Iteration> iterations;

  int steps(Phase phase) const {
    return static_cast<int>(std::ranges::count(iterations, phase, &Iteration::phase));
  }
  int coarse_factorizations() const {
    int most = 0;
    for (const Iteration& i : iterations)
      if (i.phase == Phase::coarse) most = std::max(most, i.factorizations);
    return most;
  }
};

/// Runs to the end; every mesh on the way is proved, totals only rise, and coarse steps come first.
Course run(Method& method) {
  Course course;
  Iteration before;
  bool was_coarse = true;
  while (const auto iteration = method.step({})) {
    const bool is_coarse = iteration->phase == Phase::coarse;
    EXPECT_TRUE(was_coarse || !is_coarse);
    EXPECT_TRUE(is_valid(method.mesh())) << "step " << course.iterations.size();
    EXPECT_GE(iteration->factorizations, before.factorizations);
    EXPECT_GE(iteration->updates, before.updates);
    EXPECT_GE(iteration->flips, before.flips);
    EXPECT_GE(iteration->splits, before.splits);
    EXPECT_GE(iteration->seconds, before.seconds);
    if (!course.iterations.empty()) {
      EXPECT_EQ(iteration->inner, before.inner + 1);
    }
    before = *iteration;
    was_coarse = is_coarse;
    course.iterations.push_back(*iteration);
  }
  return course;
}

void expect_on_target(const Method& method, const Problem& problem) {
  EXPECT_EQ(method.outcome(), Outcome::gradient);
  for (const Handle& handle : problem.handles)
    if (handle.kind != HandleKind::soft) {
      EXPECT_EQ(Vec2(method.mesh().deformed().col(handle.vertex)), handle.target) << handle.vertex;
    }
}

TEST(Coarse, ABendEndsLikeTheOneOfTheFineMeshWithFewFactorizationsOfIt) {
  const Problem problem = bent_bar();
  Foldless method(problem, kSmall), fine(problem, kNever);
  const Course course = run(method), of_fine = run(fine);
  expect_on_target(method, problem);
  expect_on_target(fine, problem);
  EXPECT_EQ(of_fine.steps(Phase::coarse), 0);
  EXPECT_GT(course.steps(Phase::coarse), 2);
  EXPECT_EQ(course.steps(Phase::coarse) + course.steps(Phase::settle),
            static_cast<int>(course.iterations.size()))
      << "handles are on their targets when the fine mesh begins";
  EXPECT_LE(2 * (course.iterations.back().factorizations - course.coarse_factorizations()),
            of_fine.iterations.back().factorizations);
  EXPECT_NEAR(course.iterations.back().distortion_energy,
              of_fine.iterations.back().distortion_energy,
              0.02 * of_fine.iterations.back().distortion_energy);
}

TEST(Coarse, ATwistWithAHeldBoundaryEndsOnTarget) {
  const Problem problem = test::turned_disk(
      {.disk = {.rings = 15, .boundary_vertices = 90, .vertices = 750, .radius = 0.35},
       .ring = 7,
       .degrees = 120,
       .energy = "dirichlet"});
  Foldless method(problem, kSmall);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, AMeshIsDenseFromTwoThousandVertices) {
  for (const int columns : {44, 45}) {  // 45 × 44 and 46 × 44
    Foldless method(bent_grid(columns, 43));
    const auto first = method.step({});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->phase == Phase::coarse, columns == 45) << columns;
  }
}

TEST(Coarse, ADenseMeshIsSolvedWhole) {
  const Problem problem = bent_grid(180, 45);
  ASSERT_GE(problem.mesh.vertex_count(), CoarseSettings().dense_from);
  Foldless method(problem);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, ACoarseMeshThatIsDenseIsCoarsenedToo) {
  const Problem problem = bent_grid(120, 30);
  const CoarseSettings once{.dense_from = 3000, .least_vertices = 900, .ratio = 4};
  const CoarseSettings twice{.dense_from = 900, .least_vertices = 300, .ratio = 4};
  Foldless one(problem, once), two(problem, twice);
  const Course of_one = run(one), of_two = run(two);
  expect_on_target(one, problem);
  expect_on_target(two, problem);
  EXPECT_NE(of_one.iterations.front().energy, of_two.iterations.front().energy);
}

TEST(Coarse, TheMeshStaysWhatItWasUntilTheCoarseOneIsSolved) {
  const Problem problem = bent_bar();
  Foldless method(problem, kSmall);
  int unchanged = 0;
  for (auto iteration = method.step({}); iteration && iteration->phase == Phase::coarse;
       iteration = method.step({}))
    if (method.mesh().deformed() == problem.mesh.deformed()) ++unchanged;
  EXPECT_GT(unchanged, 2);
}

TEST(Coarse, StepsThatAreCancelledChangeNothing) {
  const Problem problem = bent_bar();
  Foldless straight(problem, kSmall);
  run(straight);
  std::stop_source stopped;
  stopped.request_stop();
  for (const int every : {1, 2, 3}) {
    Foldless method(problem, kSmall);
    for (int step = 0; !method.outcome(); ++step) {
      if (step % every == 0) {
        EXPECT_FALSE(method.step(stopped.get_token()));
      }
      method.step({});
    }
    EXPECT_TRUE(method.mesh().deformed() == straight.mesh().deformed()) << "every " << every;
    EXPECT_TRUE(method.mesh().triangles() == straight.mesh().triangles()) << "every " << every;
  }
}

TEST(Coarse, ACopyGoesOnLikeTheOriginal) {
  const Problem problem = bent_bar();
  for (const int steps : {0, 1, 4}) {
    SCOPED_TRACE(testing::Message() << "after " << steps << " steps");
    Foldless method(problem, kSmall);
    for (int i = 0; i < steps; ++i) ASSERT_EQ(method.step({})->phase, Phase::coarse);
    const std::unique_ptr<Method> copy = method.clone();
    const Course course = run(method), of_copy = run(*copy);
    EXPECT_EQ(course.steps(Phase::coarse), of_copy.steps(Phase::coarse));
    expect_on_target(*copy, problem);
    EXPECT_LE((method.mesh().deformed() - copy->mesh().deformed()).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(Coarse, ACopyTakesTheStageOfAnother) {
  Foldless one(bent_bar(), kSmall), other(one);
  for (int i = 0; i < 3; ++i) one.step({});
  other = one;
  const auto next = one.step({}), next_of_other = other.step({});
  ASSERT_TRUE(next && next_of_other);
  EXPECT_EQ(next->inner, next_of_other->inner);
  EXPECT_NEAR(next->energy, next_of_other->energy, 1e-9 * next->energy);
}

TEST(Coarse, NewTargetsArePursuedFromTheMeshAsItIs) {
  Problem problem = bent_bar();
  Foldless method(problem, kSmall);
  ASSERT_EQ(method.step({})->phase, Phase::coarse);
  for (Handle& handle : problem.handles)
    handle.target = problem.mesh.rest().col(handle.vertex) * 1.1;
  method.set_targets(constraints_of(problem.handles).targets);
  EXPECT_EQ(run(method).steps(Phase::coarse), 0);
  expect_on_target(method, problem);
}

TEST(Coarse, WhereTheCoarseRunLocksTheFineMeshBeginsAsItWas) {
  Problem problem{grid_mesh(60, 14), find_density("arap"), {}, {}};
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (problem.mesh.is_boundary_vertex(v))
      problem.handles.push_back(test::held(problem.mesh.rest(), v));
  problem.handles.push_back(test::held(problem.mesh.rest(), 7 * 61 + 30));
  problem.handles.back().target = Vec2(1.2, 0.1);  // out of the held boundary
  Foldless method(problem, kSmall);
  std::optional<Iteration> iteration;
  int coarse_steps = 0;
  do {
    EXPECT_TRUE(method.mesh().deformed() == problem.mesh.deformed());
    iteration = method.step({});
    ++coarse_steps;
  } while (iteration && iteration->phase == Phase::coarse);
  EXPECT_GT(coarse_steps, 5);
  run(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_GT(method.mesh().deformed()(0, 7 * 61 + 30), 0.6) << "it is brought near";
}

TEST(Coarse, HandlesThatAreAtTheirTargetsNeedNoCoarseMesh) {
  Problem problem = bent_bar();
  for (Handle& handle : problem.handles) handle.target = problem.mesh.rest().col(handle.vertex);
  Foldless method(problem, kSmall);
  EXPECT_EQ(run(method).steps(Phase::coarse), 0);
}

TEST(Coarse, AMeshOfWhichFewVerticesMayGoIsNotCoarsened) {
  Foldless method(bent_grid(300, 2), kSmall);
  EXPECT_NE(method.step({})->phase, Phase::coarse);
}

/// A second grid beside the first that has no handle, in a pose of its own, and a vertex that no
/// triangle uses.
Problem with_idle_component(Problem problem, std::uint64_t seed) {
  const MeshPair first = problem.mesh, second = grid_mesh(30, 20);
  const int n = first.vertex_count(), m = second.vertex_count();
  Triangles triangles(3, first.face_count() + second.face_count());
  triangles << first.triangles(), (second.triangles().array() + n).matrix();
  Points rest(2, n + m + 1);
  rest << first.rest(), second.rest().colwise() + Vec2(0, 1), Vec2(0.4, 0.4);
  Points deformed = rest;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  for (int v = n; v < n + m; ++v) deformed.col(v) += 0.01 * Vec2(unit(random), unit(random));
  problem.mesh = MeshPair(triangles, rest, deformed);
  return problem;
}

TEST(Coarse, WhatDoesNotMoveStaysExactlyWhereItIs) {
  const Problem problem = with_idle_component(bent_grid(90, 20), 4);
  ASSERT_TRUE(is_valid(problem.mesh));
  const int first = 91 * 21;
  Foldless method(problem, kSmall);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
  const Eigen::Index others = problem.mesh.vertex_count() - first;
  EXPECT_TRUE(method.mesh().deformed().rightCols(others) ==
              problem.mesh.deformed().rightCols(others));
}

TEST(Coarse, AnIdleComponentMayBeFlatterThanTheBoundOnAreas) {
  Problem problem = with_idle_component(bent_grid(90, 20), 4);
  Points deformed = problem.mesh.deformed();
  deformed.rightCols(31 * 21 + 1).row(1) *= 0.05;
  problem.mesh.set_deformed(deformed);
  ASSERT_TRUE(is_valid(problem.mesh));
  problem.parameters.delta = 0.1;
  Foldless method(problem, kSmall);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, SoftHandlesKeepTheirVertices) {
  Problem problem = bent_bar();
  problem.handles.push_back(test::held(problem.mesh.rest(), 7 * 61 + 30));
  problem.handles.back().kind = HandleKind::soft;
  problem.handles.back().target += Vec2(0.05, 0.1);
  Foldless method(problem, kSmall);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, AMeshThatWasSplitBeforeKeepsItsOriginalVerticesAndHandles) {
  Problem problem = bent_bar();
  const MeshPair original = problem.mesh;
  for (int e = 0; e < 60; ++e) problem.mesh.split_edge(7 * e, 0.4);
  problem.original = OriginalMesh{std::make_shared<const Triangles>(original.triangles()),
                                  original.vertex_count()};
  problem.handles.push_back(test::held(problem.mesh.rest(), original.vertex_count() + 30));
  problem.handles.back().kind = HandleKind::soft;
  Foldless method(problem, kSmall);
  EXPECT_GT(run(method).steps(Phase::coarse), 2);
  expect_on_target(method, problem);
  const int kept = original.vertex_count() + 31;
  EXPECT_EQ(method.mesh().rest().leftCols(kept), problem.mesh.rest().leftCols(kept));
}

TEST(Coarse, IsValidOnRandomScenesWhateverIsCancelledAndResumed) {
  const CoarseSettings tiny{.dense_from = 100, .least_vertices = 60, .ratio = 6};
  int coarse_steps = 0, arrived = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-0.5, 0.5);
    Problem problem{grid_mesh(14, 14), &densities()[random() % densities().size()], {}, {}};
    std::set<int> vertices;
    while (vertices.size() < 5) vertices.insert(static_cast<int>(random() % 225));
    for (const int v : vertices) {
      problem.handles.push_back(test::held(problem.mesh.rest(), v));
      problem.handles.back().target += 0.5 * Vec2(unit(random), unit(random));
    }
    Foldless method(problem, tiny);
    std::stop_source stopped;
    stopped.request_stop();
    bool was_coarse = false;
    for (int step = 0; step < 200 && !method.outcome(); ++step) {
      if (random() % 4 == 0) {
        EXPECT_FALSE(method.step(stopped.get_token()));
      }
      const auto iteration = method.step({});
      ASSERT_TRUE(iteration);
      ASSERT_TRUE(is_valid(method.mesh())) << "step " << step;
      const bool is_coarse = iteration->phase == Phase::coarse;
      coarse_steps += is_coarse;
      arrived += was_coarse && iteration->phase == Phase::settle;
      was_coarse = is_coarse;
    }
  }
  EXPECT_GT(coarse_steps, 30 * 5) << "the claim would be empty";
  EXPECT_GT(arrived, 15);
}

}  // namespace
}  // namespace foldless
