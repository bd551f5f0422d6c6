// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness reaches every stage of a method and stays with the rest mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/run/run.h"
#include "tests/core/run/run_fixture.h"

namespace foldless {
namespace {

constexpr double kFactor = 300;

/// A bar of length 4 and height 1, held at the left; its right end is pulled up and shortened.
Problem bar(std::string_view method, int columns = 24) {
  const Shape shape = grid({.columns = columns, .rows = columns / 4, .width = 4, .height = 1});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  problem.parameters.method = method;
  const double right = shape.rest.row(0).maxCoeff(), left = shape.rest.row(0).minCoeff();
  for (int v = 0; v < problem.mesh.vertex_count(); ++v) {
    const Vec2 p = shape.rest.col(v);
    if (p.x() != left && p.x() != right) continue;
    const Vec2 target = p.x() == left ? p : Vec2(p + Vec2(-0.8, 1.2));
    problem.handles.push_back({.id = v, .vertex = v, .target = target});
  }
  return problem;
}

/// So much stiffer along the middle third.
void stiffen(Problem& problem) {
  const Vec2 middle = problem.mesh.rest().rowwise().mean();
  const double length =
      problem.mesh.rest().row(0).maxCoeff() - problem.mesh.rest().row(0).minCoeff();
  Points line(2, 2);
  line << middle.x() - length / 24, middle.x() + length / 24,  //
      middle.y(), middle.y();
  problem.mesh.set_stiffness(
      std::make_shared<const Stiffness>(std::vector<StiffStroke>{{line, length / 8, kFactor}}));
}

/// The mean of ‖J − R‖² in the middle and elsewhere, by rest area.
struct Strain {
  double in_the_middle = 0, elsewhere = 0;
};

Strain strain(const Problem& problem, const Snapshot& end) {
  const Stiffness& stiffness = *problem.mesh.stiffness();
  Strain sum, area;
  for (const auto& t : end.triangles->colwise()) {
    const Points corners = (*end.rest)(Eigen::all, t);
    const bool is_stiff = stiffness.at(corners.rowwise().mean()) != 1;
    const double a = signed_area(*end.rest, t);
    const double e = find_density("arap")->value(deformation_gradient(*end.rest, end.deformed, t));
    (is_stiff ? sum.in_the_middle : sum.elsewhere) += a * e;
    (is_stiff ? area.in_the_middle : area.elsewhere) += a;
  }
  return {sum.in_the_middle / area.in_the_middle, sum.elsewhere / area.elsewhere};
}

std::shared_ptr<const Snapshot> solved(const Problem& problem) {
  foldless::Run run(problem);
  test::finish(run, 5000);
  EXPECT_TRUE(run.is_satisfied());
  EXPECT_TRUE(is_injective(*run.snapshot()->triangles, run.snapshot()->deformed));
  return run.snapshot();
}

class StiffParts : public testing::TestWithParam<const char*> {};

TEST_P(StiffParts, KeepTheirShape) {
  Problem problem = bar(GetParam());
  const auto soft = solved(problem);
  stiffen(problem);
  const Strain before = strain(problem, *soft), after = strain(problem, *solved(problem));
  EXPECT_GT(before.in_the_middle, 0.3 * before.elsewhere);
  EXPECT_LT(after.in_the_middle, 0.02 * after.elsewhere);
}

INSTANTIATE_TEST_SUITE_P(Methods, StiffParts,
                         testing::Values("foldless", "paper", "paper-flip", "paper-noflip", "lim"),
                         [](const auto& which) {
                           std::string name = which.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(StiffPart, KeepsItsShapeOnADenseMeshThatIsSolvedCoarselyFirst) {
  Problem problem = bar("foldless", 100);
  ASSERT_GT(problem.mesh.vertex_count(), 2000);
  stiffen(problem);
  const Strain after = strain(problem, *solved(problem));
  EXPECT_LT(after.in_the_middle, 0.02 * after.elsewhere);
}

TEST(StiffPart, IsTheSameInAnyUnitOfLength) {
  Problem problem = bar("foldless");
  stiffen(problem);
  const auto end = solved(problem);
  for (const double unit : {1e-6, 1.3, 1e6}) {
    Problem other = test::placed(bar("foldless"), unit, Vec2::Zero());
    stiffen(other);
    const Strain in_unit = strain(other, *solved(other)), in_one = strain(problem, *end);
    // What is left in the middle is where descents end, a hundred-thousandth of what is elsewhere.
    EXPECT_NEAR(in_unit.in_the_middle, in_one.in_the_middle, 1e-4 * in_one.elsewhere);
    EXPECT_NEAR(in_unit.elsewhere, in_one.elsewhere, 1e-3 * in_one.elsewhere);
  }
}

TEST(StiffPart, CountsBesideAPartWithoutHandles) {
  Problem problem = bar("foldless");
  const Points& rest = problem.mesh.rest();
  Points with_other(2, rest.cols() + 3);
  with_other.rightCols(rest.cols()) = rest;
  with_other.leftCols(3) << 9, 10, 9,  //
      0, 0, 1;
  Triangles triangles(3, problem.mesh.face_count() + 1);
  triangles.col(0) << 0, 1, 2;
  triangles.rightCols(problem.mesh.face_count()) = problem.mesh.triangles().array() + 3;
  Problem both = problem;
  both.mesh = MeshPair(triangles, with_other);
  for (Handle& handle : both.handles) handle.vertex += 3;
  stiffen(problem);
  both.mesh.set_stiffness(problem.mesh.stiffness());
  const Strain after = strain(both, *solved(both));
  EXPECT_LT(after.in_the_middle, 0.02 * after.elsewhere);
}

TEST(StiffPart, StaysStiffWhenARunIsResumed) {
  Problem problem = bar("foldless");
  stiffen(problem);
  foldless::Run run(problem);
  test::finish(run, 3);
  EXPECT_EQ(run.resumed().mesh.stiffness(), problem.mesh.stiffness());
}

}  // namespace
}  // namespace foldless
