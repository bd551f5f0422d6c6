// SPDX-License-Identifier: GPL-3.0-or-later
// The stage on a coarser mesh: Foldless::coarse_to_fine().
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/method/foldless/foldless.h"
#include "tests/core/method/foldless/coarse_scenes.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

using test::bent_bar;
using test::bent_grid;
using test::expect_on_target;
using test::kNever;
using test::kSmall;
using test::run_validly;

int steps(const std::vector<Iteration>& records, Phase phase) {
  return static_cast<int>(std::ranges::count(records, phase, &Iteration::phase));
}

TEST(Coarse, ABendEndsLikeTheOneOfTheFineMeshWithFewFactorizationsOfIt) {
  const Problem problem = bent_bar();
  Foldless method(problem, kSmall), fine(problem, kNever);
  const std::vector<Iteration> course = run_validly(method), of_fine = run_validly(fine);
  expect_on_target(method, problem);
  expect_on_target(fine, problem);
  EXPECT_EQ(steps(of_fine, Phase::coarse), 0);
  const int coarse_steps = steps(course, Phase::coarse);
  EXPECT_GT(coarse_steps, 2);
  for (std::size_t i = 0; i < course.size(); ++i)
    EXPECT_EQ(course[i].phase, static_cast<int>(i) < coarse_steps ? Phase::coarse : Phase::settle)
        << "handles are on their targets when the fine mesh begins";
  const int coarse_factorizations =
      course[static_cast<std::size_t>(coarse_steps) - 1].factorizations;
  EXPECT_LE(2 * (course.back().factorizations - coarse_factorizations),
            of_fine.back().factorizations);
  EXPECT_NEAR(course.back().distortion_energy, of_fine.back().distortion_energy,
              0.02 * of_fine.back().distortion_energy);
}

TEST(Coarse, AFineMeshOfAMildBendIsSettledWithoutAFactorizationOfIt) {
  Problem problem = bent_grid(120, 30);
  for (Handle& handle : problem.handles) {
    const Vec2 rest = problem.mesh.rest().col(handle.vertex);
    handle.target = rest + 0.25 * (handle.target - rest);
  }
  problem.handles.push_back(test::held(problem.mesh.rest(), 15 * 121 + 60));
  problem.handles.back().kind = HandleKind::soft;
  Foldless method(problem, kSmall), fine(problem, kNever);
  const std::vector<Iteration> course = run_validly(method), of_fine = run_validly(fine);
  const int coarse_steps = steps(course, Phase::coarse);
  ASSERT_GT(steps(course, Phase::settle), 0);
  EXPECT_EQ(course.back().factorizations,
            course[static_cast<std::size_t>(coarse_steps) - 1].factorizations);
  EXPECT_NEAR(course.back().distortion_energy, of_fine.back().distortion_energy,
              0.01 * of_fine.back().distortion_energy);
  expect_on_target(method, problem);
}

TEST(Coarse, ATwistWithAHeldBoundaryEndsOnTarget) {
  const Problem problem = test::turned_disk(
      {.disk = {.rings = 15, .boundary_vertices = 90, .vertices = 750, .radius = 0.35},
       .ring = 7,
       .degrees = 120,
       .energy = "dirichlet"});
  Foldless method(problem, kSmall);
  EXPECT_GT(steps(run_validly(method), Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, TheCoarseRunTriesNoOtherMaps) {
  const Problem problem = test::turned_disk(
      {.disk = {.rings = 15, .boundary_vertices = 90, .vertices = 750, .radius = 0.35},
       .ring = 7,
       .degrees = 185});
  Foldless method(problem, kSmall), alone(coarse_problem(problem, kSmall)->problem, kSmall);
  const std::vector<Iteration> course = run_validly(method), of_coarse = run_validly(alone);
  const auto last =
      std::ranges::find(course.rbegin(), course.rend(), Phase::coarse, &Iteration::phase);
  ASSERT_NE(last, course.rend());
  EXPECT_LT(last->factorizations, of_coarse.back().factorizations);
  ASSERT_NE(last.base(), course.end());
  EXPECT_EQ(last.base()->phase, Phase::settle) << "the fine mesh takes its map over";
  expect_on_target(method, problem);
}

TEST(Coarse, ADenseMeshIsSolvedWhole) {
  const Problem problem = bent_grid(180, 45);
  ASSERT_GE(problem.mesh.vertex_count(), CoarseSettings().dense_from);
  Foldless method(problem);
  EXPECT_GT(steps(run_validly(method), Phase::coarse), 2);
  expect_on_target(method, problem);
}

TEST(Coarse, ACoarseMeshThatIsDenseIsCoarsenedToo) {
  const Problem problem = bent_grid(120, 30);
  const CoarseSettings once{.dense_from = 3000, .least_vertices = 900, .ratio = 4};
  const CoarseSettings twice{.dense_from = 900, .least_vertices = 300, .ratio = 4};
  Foldless one(problem, once), two(problem, twice);
  const std::vector<Iteration> of_one = run_validly(one), of_two = run_validly(two);
  expect_on_target(one, problem);
  expect_on_target(two, problem);
  EXPECT_NE(of_one.front().energy, of_two.front().energy);
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
  run_validly(straight);
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

TEST(Coarse, NewTargetsArePursuedFromTheMeshAsItIs) {
  Problem problem = bent_bar();
  Foldless method(problem, kSmall);
  ASSERT_EQ(method.step({})->phase, Phase::coarse);
  for (Handle& handle : problem.handles)
    handle.target = problem.mesh.rest().col(handle.vertex) * 1.1;
  method.set_targets(constraints_of(problem.handles).targets);
  EXPECT_EQ(steps(run_validly(method), Phase::coarse), 0);
  expect_on_target(method, problem);
}

TEST(Coarse, WhereTheCoarseRunLocksTheFineMeshBeginsAsItWas) {
  Problem problem{test::grid_mesh(60, 14), find_density("arap"), {}, {}};
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (problem.mesh.is_boundary_vertex(v))
      problem.handles.push_back(test::held(problem.mesh.rest(), v));
  problem.handles.push_back(test::held(problem.mesh.rest(), 7 * 61 + 30));
  problem.handles.back().target = Vec2(1.2, 0.1);  // out of the held boundary
  Foldless method(problem, kSmall);
  int coarse_steps = 0;
  std::optional<Iteration> iteration;
  do {
    EXPECT_TRUE(method.mesh().deformed() == problem.mesh.deformed());
    iteration = method.step({});
    ++coarse_steps;
  } while (iteration && iteration->phase == Phase::coarse);
  EXPECT_GT(coarse_steps, 5);
  run_validly(method);
  EXPECT_EQ(method.outcome(), Outcome::infeasible);
  EXPECT_GT(method.mesh().deformed()(0, 7 * 61 + 30), 0.6) << "it is brought near";
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
  EXPECT_GT(steps(run_validly(method), Phase::coarse), 2);
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
    Problem problem{test::grid_mesh(14, 14), &densities()[random() % densities().size()], {}, {}};
    std::set<int> vertices;
    while (vertices.size() < 5) vertices.insert(static_cast<int>(random() % 225));
    for (const int v : vertices) {
      problem.handles.push_back(test::held(problem.mesh.rest(), v));
      problem.handles.back().target += 0.5 * test::random_vector(unit, random);
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
      ASSERT_TRUE(test::is_valid(method.mesh())) << "step " << step;
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
