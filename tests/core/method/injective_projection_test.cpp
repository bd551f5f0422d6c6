// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/injective_projection.h"

#include <gtest/gtest.h>

#include "core/mesh/quality.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/errors.h"

namespace foldless {
namespace {

using test::pulled_grid;
using test::run_to_its_end;

int folded_triangles(const Method& method) {
  const InjectivityReport report =
      check_injectivity(method.mesh().triangles(), method.mesh().deformed());
  return report.inverted + report.degenerate;
}

TEST(InjectiveProjection, ComesFromAFoldedMapToOneWithinTheBound) {
  Problem disk = test::turned_disk({.degrees = 150});
  disk.parameters.distortion_bound = 130;
  InjectiveProjection method(disk);
  std::vector<int> folded;
  Iteration last;
  while (const auto now = method.step({})) {
    last = *now;
    folded.push_back(folded_triangles(method));
    EXPECT_TRUE(std::isfinite(now->energy));
    EXPECT_EQ(now->min_area_ratio > 0, folded.back() == 0);
    EXPECT_LE(now->handle_error_squared, kSatisfied * 0.49);
  }
  ASSERT_GT(folded.size(), 2U);
  EXPECT_GT(folded.front(), 0) << "the scene was chosen to fold";
  EXPECT_EQ(folded.back(), 0);
  EXPECT_EQ(method.outcome(), Outcome::step);
  EXPECT_LE(last.max_conformal_distortion, 130 * (1 + 1e-4));
  EXPECT_TRUE(test::is_satisfied(method, last));
}

TEST(InjectiveProjection, AMinimumWithinTheBoundIsTheResult) {
  for (const std::string_view energy : {"dirichlet", "lscm", "arap"}) {
    SCOPED_TRACE(energy);
    InjectiveProjection method(pulled_grid(energy, Vec2(0.05, 0.1)));
    const Iteration last = run_to_its_end(method);
    EXPECT_EQ(method.outcome(), Outcome::step);
    EXPECT_EQ(last.updates, 1);
    EXPECT_TRUE(test::is_satisfied(method, last));
  }
}

TEST(InjectiveProjection, SaysWhenItsMapStaysFolded) {
  // Two opposite corners change places: no map of a small bound does that in a hundred programs.
  Problem problem = pulled_grid("dirichlet", Vec2(-0.9, -0.9));
  problem.parameters.distortion_bound = 1.5;
  problem.parameters.inner_iterations = 5;
  InjectiveProjection method(problem);
  run_to_its_end(method);
  ASSERT_TRUE(method.outcome());
  EXPECT_NE(method.outcome(), Outcome::step);
  EXPECT_FALSE(method.verdict().empty());
}

TEST(InjectiveProjection, SaysWhenAMapWithoutFoldsWindsTwice) {
  const Shape shape = grid({.columns = 4, .rows = 4, .width = 0.7, .height = 0.7});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("lscm"), {}, {}};
  for (const int v : {0, 4, 20, 24, 12}) problem.handles.push_back(test::held(shape.rest, v));
  problem.handles.back().target = Vec2(0.735, 0.665);  // beyond the corner that is held
  InjectiveProjection method(problem);
  run_to_its_end(method);
  EXPECT_EQ(method.outcome(), Outcome::step);
  EXPECT_EQ(folded_triangles(method), 0);
  EXPECT_EQ(method.verdict(), "fold-free but 1 interior vertex winds twice");
}

TEST(InjectiveProjection, RefusesEnergiesThatAreNotQuadratic) {
  EXPECT_EQ(
      test::error_of([] { InjectiveProjection(pulled_grid("symmetric-dirichlet", Vec2::Zero())); }),
      "method 'injective-projection' has no energy 'symmetric-dirichlet'; choose dirichlet, "
      "lscm or arap");
}

TEST(InjectiveProjection, ACancelledStepChangesNothingAndTheRunGoesOnAsIfThereHadBeenNone) {
  Problem disk = test::turned_disk({.degrees = 120});
  disk.parameters.distortion_bound = 60;
  InjectiveProjection method(disk), undisturbed(disk);
  ASSERT_TRUE(method.step({}));
  const Points before = method.mesh().deformed();
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(method.step(source.get_token()));
  EXPECT_EQ(method.mesh().deformed(), before);
  run_to_its_end(method);
  run_to_its_end(undisturbed);
  EXPECT_EQ(method.mesh().deformed(), undisturbed.mesh().deformed());
}

}  // namespace
}  // namespace foldless
