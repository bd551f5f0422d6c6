// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/run.h"

#include <gtest/gtest.h>

#include <random>

#include "core/energy/constraints.h"
#include "core/error.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "core/method/foldless/foldless.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

using test::displace;
using test::finish;
using test::grid_problem;
using test::placed;
using test::Script;
using test::starter_of;

TEST(Run, BeginsWithTheMeshOfTheProblemBitForBit) {
  Problem problem = placed(grid_problem(5, Vec2(5, 3)), 0.1, Vec2(1e3 / 3, -77.7));
  displace(problem.mesh, 12, Vec2(0.01, 0.02));
  const foldless::Run run(problem, 7);
  const Snapshot& first = *run.snapshot();
  EXPECT_EQ(*first.rest, problem.mesh.rest());
  EXPECT_EQ(first.deformed, problem.mesh.deformed());
  EXPECT_EQ(*first.triangles, problem.mesh.triangles());
  EXPECT_EQ(first.handles, problem.handles);
  EXPECT_EQ(first.generation, 7U);
  EXPECT_EQ(first.original_vertices, 25);
  EXPECT_FALSE(first.iteration);
  EXPECT_TRUE(first.flipped_edges->empty());
}

TEST(Run, PublishesItsOwnMeshWhileFoldlessSolvesACoarserOne) {
  const MethodStarter start = [](const Problem& problem) -> std::unique_ptr<Method> {
    return std::make_unique<Foldless>(
        problem, CoarseSettings{.dense_from = 100, .least_vertices = 60, .ratio = 6});
  };
  Problem bent = grid_problem(15, Vec2(16, 9));
  bent.handles.push_back({.id = 3, .vertex = 14, .target = bent.mesh.rest().col(14)});
  const Problem problem = placed(bent, 7, Vec2(3, -2));
  foldless::Run run(problem, 0, start);
  int coarse_steps = 0;
  bool is_coarse = true;
  while (const auto record = run.step({})) {
    const Snapshot& shown = *run.snapshot();
    EXPECT_TRUE(is_injective(*shown.triangles, *shown.rest, shown.deformed));
    ASSERT_TRUE(shown.iteration);
    EXPECT_EQ(shown.iteration->inner, record->inner);
    EXPECT_TRUE(*shown.rest == problem.mesh.rest());
    is_coarse = is_coarse && record->phase == Phase::coarse;
    if (!is_coarse) continue;
    ++coarse_steps;
    // The last coarse step brings the map.
    EXPECT_EQ(run.is_satisfied(), !shown.deformed.isApprox(problem.mesh.rest()));
  }
  EXPECT_GT(coarse_steps, 1);
  EXPECT_TRUE(run.is_satisfied());
}

TEST(Run, WorksOnAMeshOfDiagonalOne) {
  for (const double scale : {1e-6, 0.3, 1.0, 12345.0}) {
    const foldless::Run run(placed(grid_problem(6, Vec2(6, 6)), scale, Vec2(100, -3)));
    const double diagonal = 5 * std::sqrt(2.0) * scale * run.normalisation().scale;
    EXPECT_GE(diagonal, std::sqrt(0.5) * 0.999999);
    EXPECT_LE(diagonal, std::sqrt(2.0) * 1.000001);
  }
}

TEST(Run, KeepsRestPositionsBitForBitAndSharesWhatDoesNotChange) {
  Problem problem = placed(grid_problem(6, Vec2(2.5, 2.2)), 1.0 / 3, Vec2(0.1, 1e2 / 7));
  problem.energy = find_density("lscm");
  foldless::Run run(problem);
  auto before = run.snapshot();
  int flipping_steps = 0;
  while (run.step({})) {
    const auto now = run.snapshot();
    ASSERT_EQ(*now->rest, problem.mesh.rest());
    ASSERT_TRUE(is_injective(*now->triangles, *now->rest, now->deformed));
    if (now->revision == before->revision) {
      EXPECT_EQ(now->triangles, before->triangles);
      EXPECT_EQ(now->rest, before->rest);
      EXPECT_EQ(now->flipped_edges, before->flipped_edges);
    } else {
      ++flipping_steps;
      EXPECT_NE(*now->triangles, *before->triangles);
    }
    before = now;
  }
  EXPECT_GT(flipping_steps, 0) << "the scene was chosen to flip edges";
  EXPECT_GT(before->flipped_edges->size(), 0U);
}

TEST(Run, ReportsInInputUnits) {
  // Scaling the input by a power of two gives the solver the very same problem.
  Problem problem = grid_problem(5, Vec2(2.5, 2));
  problem.energy = find_density("arap");
  const double s = 1024;
  foldless::Run small(problem);
  foldless::Run large(placed(problem, s, Vec2::Zero()));
  const auto a = finish(small);
  const auto b = finish(large);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 2U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].energy * s * s, b[i].energy);
    EXPECT_EQ(a[i].distortion_energy * s * s, b[i].distortion_energy);
    EXPECT_EQ(a[i].penalty_energy * s * s, b[i].penalty_energy);
    EXPECT_EQ(a[i].barrier_energy * s * s, b[i].barrier_energy);
    EXPECT_EQ(a[i].gradient_norm_squared * s * s, b[i].gradient_norm_squared);
    EXPECT_EQ(a[i].handle_error_squared * s * s, b[i].handle_error_squared);
    EXPECT_EQ(a[i].step_infinity_norm * s, b[i].step_infinity_norm);
    EXPECT_EQ(a[i].mu, b[i].mu);
    EXPECT_EQ(a[i].min_area_ratio, b[i].min_area_ratio);
    EXPECT_EQ(a[i].factorizations, b[i].factorizations);
  }
}

TEST(Run, RecordsAgreeWithTheSnapshot) {
  const Density& dirichlet = *find_density("dirichlet");
  foldless::Run run(placed(grid_problem(5, Vec2(4.5, 5)), 37.5, Vec2(-2, 8)));
  while (const auto record = run.step({})) {
    const Snapshot& now = *run.snapshot();
    const double error = handle_error_squared(constraints_of(now.handles), now.deformed);
    EXPECT_NEAR(record->handle_error_squared, error, 1e-9 * error + 1e-18 * 37.5 * 37.5);
    const Quality quality = quality_of(*now.triangles, *now.rest, now.deformed);
    EXPECT_NEAR(record->min_area_ratio, quality.min_area_ratio, 1e-9);
    double distortion = 0;
    for (const auto& t : now.triangles->colwise())
      distortion += signed_area(*now.rest, t) *
                    dirichlet.value(deformation_gradient(*now.rest, now.deformed, t));
    EXPECT_NEAR(record->distortion_energy, distortion, 1e-9 * distortion);
  }
}

TEST(Run, SatisfiedMeansEveryHardHandleAtItsTarget) {
  Problem problem = grid_problem(4, Vec2(3.3, 3.1));
  problem.handles.push_back(
      {.id = 3, .vertex = 3, .target = Vec2(9, -9), .kind = HandleKind::soft, .weight = 1e-9});
  foldless::Run run(problem);
  EXPECT_FALSE(run.is_satisfied());
  finish(run);
  EXPECT_TRUE(run.is_satisfied());
  EXPECT_LT((run.snapshot()->deformed.col(15) - Vec2(3.3, 3.1)).norm(), 1e-5 * 3 * std::sqrt(2.0));
}

TEST(Run, NewTargetsBeginItAgainAndShowInTheSnapshot) {
  foldless::Run run(grid_problem(4, Vec2(3.3, 3.1)));
  finish(run);
  ASSERT_TRUE(run.outcome());
  Points targets(2, 2);
  targets << 0, 3.1,  //
      0, 3.4;
  run.set_targets(targets);
  EXPECT_FALSE(run.outcome());
  EXPECT_FALSE(run.is_satisfied());
  EXPECT_EQ(run.snapshot()->handles[1].target, Vec2(3.1, 3.4));
  EXPECT_FALSE(finish(run).empty());
  EXPECT_TRUE(run.is_satisfied());
}

TEST(Run, NeverPublishesAFoldedMesh) {
  const auto script = std::make_shared<Script>();
  script->length = 40;
  // Every third iteration folds a corner over its neighbours, the next takes it back.
  script->change = [](MeshPair& mesh, int k) {
    displace(mesh, 24, Vec2(1e-3, 0));
    if (k % 3 == 0) displace(mesh, 6, Vec2(0.9, 0.9));
    if (k % 3 == 1 && k > 1) displace(mesh, 6, Vec2(-0.9, -0.9));
  };
  const Problem problem = grid_problem(5, Vec2(5, 5));
  foldless::Run run(problem, 0, starter_of(script));
  int refused = 0;
  for (int k = 1; k <= 40; ++k) {
    const auto before = run.snapshot();
    const auto record = run.step({});
    ASSERT_TRUE(record) << "a refused mesh does not end the run";
    const Snapshot& now = *run.snapshot();
    EXPECT_TRUE(is_injective(*now.triangles, *now.rest, now.deformed)) << k;
    EXPECT_EQ(run.snapshot() == before, k % 3 == 0) << k;
    EXPECT_EQ(now.iteration->inner, k % 3 == 0 ? k - 1 : k);
    refused += run.snapshot() == before;
  }
  EXPECT_EQ(refused, 13);
}

/// A corner is folded over in the second iteration and back in the fourth.
std::shared_ptr<Script> folding_script() {
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int k) {
    displace(mesh, 24, Vec2(1e-3, 0));
    if (k == 2) displace(mesh, 6, Vec2(0.9, 0.9));
    if (k == 4) displace(mesh, 6, Vec2(-0.9, -0.9));
  };
  return script;
}

TEST(Run, PublishesAndMarksTheFoldedMeshesOfMethodsThatMayFold) {
  Problem problem = grid_problem(5, Vec2(5, 5));
  problem.parameters.method = "injective-projection";
  foldless::Run run(problem, 0, starter_of(folding_script()));
  for (int k = 1; k <= 4; ++k) {
    const auto before = run.snapshot();
    ASSERT_TRUE(run.step({}));
    const Snapshot& now = *run.snapshot();
    EXPECT_NE(run.snapshot(), before);
    EXPECT_EQ(now.is_valid(), is_injective(*now.triangles, now.deformed)) << k;
    EXPECT_EQ(now.is_valid(), k == 1 || k == 4) << k;
    EXPECT_EQ(now.folded_triangles > 0, k == 2 || k == 3) << k;
    EXPECT_FALSE(run.is_satisfied() && !now.is_valid());
    const Problem next = run.resumed();
    EXPECT_TRUE(is_injective(next.mesh.triangles(), next.mesh.deformed()));
  }
}

TEST(Run, NewTargetsOnAFoldedMapBeginAgainAtTheLastValidOne) {
  Problem problem = grid_problem(5, Vec2(5, 5));
  problem.parameters.method = "injective-projection";
  foldless::Run run(problem, 0, starter_of(folding_script()));
  run.step({});
  const Points valid = run.snapshot()->deformed;
  run.step({});
  ASSERT_FALSE(run.snapshot()->is_valid());
  Points targets(2, 2);
  targets << 0, 3,  //
      0, 3;
  run.set_targets(targets);
  EXPECT_TRUE(run.snapshot()->is_valid());
  EXPECT_EQ(run.snapshot()->deformed, valid);
  EXPECT_EQ(run.snapshot()->handles[1].target, Vec2(3, 3));
  ASSERT_TRUE(run.step({}));
  EXPECT_TRUE(run.snapshot()->is_valid()) << "the method was started anew";
}

TEST(Run, RefusesWhatOnlyRoundingToInputUnitsFolds) {
  // Far from the origin one ulp is 0.125: what is fine in the solver's frame collapses there.
  const auto script = std::make_shared<Script>();
  script->change = [](MeshPair& mesh, int) {
    Points deformed = mesh.deformed();
    deformed *= 1e-3;
    mesh.set_deformed(deformed);
  };
  foldless::Run run(placed(grid_problem(5, Vec2(4, 4)), 1, Vec2(1e15, 1e15)), 0,
                    starter_of(script));
  const auto before = run.snapshot();
  ASSERT_TRUE(run.step({}));
  EXPECT_EQ(run.snapshot(), before);
}

TEST(Run, RefusesAFoldedStart) {
  Problem problem = grid_problem(4, Vec2(3, 3));
  displace(problem.mesh, 5, Vec2(2.5, 0));
  EXPECT_THROW(foldless::Run{problem}, Error);
}

TEST(Run, NamesTheMethodsWhenItIsUnknown) {
  Problem problem = grid_problem(4, Vec2(3, 3));
  problem.parameters.method = "magic";
  try {
    const foldless::Run run(problem);
    FAIL() << "no exception";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'magic'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("paper-flip"), std::string::npos);
  }
}

TEST(Run, CancelledStepsLeaveAValidMeshAndCanGoOn) {
  std::mt19937 random(20140701);
  Problem problem = grid_problem(8, Vec2(3, 2));
  problem.energy = find_density("arap");
  foldless::Run run(problem);
  int cancelled = 0;
  for (int k = 0; k < 400 && !run.outcome(); ++k) {
    std::stop_source source;
    if (random() % 2 == 0) source.request_stop();
    cancelled += run.step(source.get_token()) ? 0 : 1;
    const Snapshot& now = *run.snapshot();
    ASSERT_TRUE(is_injective(*now.triangles, *now.rest, now.deformed));
  }
  EXPECT_GT(cancelled, 0);
  finish(run);
  EXPECT_TRUE(run.outcome());
}

}  // namespace
}  // namespace foldless
