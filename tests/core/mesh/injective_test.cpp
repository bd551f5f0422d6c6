// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/injective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/boundary.h"
#include "core/threads/team.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

using std::numbers::pi;

/// `rim` triangles round vertex 0 whose rim goes `turns` times round it, beginning at `start`.
test::Fixture fan(int rim, int turns, double start) {
  test::Fixture f;
  f.rest.resize(2, rim + 1);
  f.rest.col(0) = Vec2(0.25, -0.5);
  f.triangles.resize(3, rim);
  for (int k = 0; k < rim; ++k) {
    const double angle = start + 2 * pi * turns * k / rim;
    f.rest.col(k + 1) = f.rest.col(0) + Vec2(std::cos(angle), std::sin(angle));
    f.triangles.col(k) << 0, k + 1, (k + 1) % rim + 1;
  }
  return f;
}

/// As parts of one mesh.
test::Fixture both(const test::Fixture& a, const test::Fixture& b) {
  test::Fixture f;
  f.rest.resize(2, a.rest.cols() + b.rest.cols());
  f.rest << a.rest, b.rest;
  f.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  f.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.rest.cols())).matrix();
  return f;
}

TEST(Injective, AcceptsFlatMeshes) {
  for (const test::Fixture& f : {test::unit_square(), test::square_grid(7), test::hexagon()})
    EXPECT_TRUE(is_injective(f.triangles, f.rest));
}

TEST(Injective, NamesAnInvertedTriangle) {
  test::Fixture f = test::square_grid(4);
  f.rest.col(5) += Vec2(1.3, 0.1);  // past its right neighbour
  const InjectivityReport report = check_injectivity(f.triangles, f.rest);
  ASSERT_GT(report.inverted, 0);
  EXPECT_LT(signed_area(f.rest, f.triangles.col(*report.first_inverted)), 0);
  EXPECT_FALSE(report.is_injective());
}

TEST(Injective, NamesADegenerateTriangle) {
  test::Fixture f = test::unit_square();
  f.rest.col(3) = Vec2(0.5, 0.5);
  const InjectivityReport report = check_injectivity(f.triangles, f.rest);
  EXPECT_EQ(report.degenerate, 1);
  EXPECT_EQ(report.first_degenerate, 1);
  EXPECT_EQ(report.inverted, 0);
}

TEST(Injective, TakesNotANumberForDegenerate) {
  test::Fixture f = test::unit_square();
  f.rest(0, 3) = std::nan("");
  EXPECT_EQ(check_injectivity(f.triangles, f.rest).degenerate, 1);
}

TEST(Injective, SeesADoubleCoverOfPositiveTriangles) {
  for (int rim : {5, 7, 8, 12})
    for (int k = 0; k < 24; ++k) {
      const test::Fixture f = fan(rim, 2, k * pi / 12);
      const InjectivityReport report = check_injectivity(f.triangles, f.rest);
      EXPECT_EQ(report.inverted + report.degenerate, 0);
      EXPECT_EQ(report.branch_vertices, 1) << rim << " from " << k * 15 << " degrees";
      EXPECT_EQ(report.first_branch_vertex, 0);
    }
}

// Rim vertices on the ray itself must be counted once, not twice or never.
TEST(Injective, AcceptsFansWithVerticesOnTheRay) {
  for (int rim : {3, 4, 8, 9})
    for (int k = 0; k < 24; ++k) {
      test::Fixture f = fan(rim, 1, k * pi / 12);
      for (int v = 1; v <= rim; ++v)
        if (std::abs(f.rest(1, v) - f.rest(1, 0)) < 1e-9) f.rest(1, v) = f.rest(1, 0);
      EXPECT_TRUE(is_injective(f.triangles, f.rest)) << rim << " from " << k * 15 << " degrees";
    }
}

TEST(Injective, NamesABoundaryVertexWoundMoreThanOnce) {
  test::Fixture f = fan(9, 2, 0.1);
  f.triangles.conservativeResize(Eigen::NoChange, 8);  // an open fan of 1.8 turns
  const InjectivityReport report = check_injectivity(f.triangles, f.rest);
  EXPECT_EQ(report.overlapping_boundary_vertices, std::vector<int>{0});
  EXPECT_TRUE(report.is_injective_inside());
  EXPECT_FALSE(is_injective(f.triangles, f.rest));
}

TEST(Injective, AsksBothMeshesOfAPair) {
  const test::Fixture f = test::square_grid(3);
  Points folded = f.rest;
  folded.col(4) += Vec2(2, 0);
  EXPECT_TRUE(is_injective(f.triangles, f.rest, f.rest));
  EXPECT_FALSE(is_injective(f.triangles, f.rest, folded));
  EXPECT_FALSE(is_injective(f.triangles, folded, f.rest));
}

TEST(Injective, InteriorVerticesAreThoseInsideAGrid) {
  const int n = 6;
  const test::Fixture f = test::square_grid(n);
  const std::vector<bool> interior =
      interior_vertices(f.triangles, boundary_neighbours(f.triangles, n * n + 1));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      EXPECT_EQ(interior[static_cast<std::size_t>(j * n + i)],
                i > 0 && j > 0 && i < n - 1 && j < n - 1);
  EXPECT_FALSE(interior[n * n]) << "a vertex without a triangle";
}

TEST(Injective, ThreadsFindTogetherWhatOneFinds) {
  test::Fixture f = test::square_grid(80);
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-0.6, 0.6);
  for (double& x : f.rest.reshaped()) x += shake(random);
  f.rest.col(80 * 80 / 2) = f.rest.col(80 * 80 / 2 + 1);
  test::Fixture open = fan(9, 2, 0.1);
  open.triangles.conservativeResize(Eigen::NoChange, 8);
  f = both(both(f, fan(9, 2, 0.1)), open);
  const InjectivityReport alone = check_injectivity(f.triangles, f.rest);
  ASSERT_GT(alone.inverted, 100);
  ASSERT_GT(alone.degenerate, 0);
  ASSERT_GT(alone.branch_vertices, 0);
  ASSERT_FALSE(alone.overlapping_boundary_vertices.empty());
  Team team(3);
  const WithTeam with(&team);
  const InjectivityReport shared = check_injectivity(f.triangles, f.rest);
  EXPECT_EQ(shared.inverted, alone.inverted);
  EXPECT_EQ(shared.degenerate, alone.degenerate);
  EXPECT_EQ(shared.branch_vertices, alone.branch_vertices);
  EXPECT_EQ(shared.first_inverted, alone.first_inverted);
  EXPECT_EQ(shared.first_degenerate, alone.first_degenerate);
  EXPECT_EQ(shared.first_branch_vertex, alone.first_branch_vertex);
  EXPECT_EQ(shared.overlapping_boundary_vertices, alone.overlapping_boundary_vertices);
}

// The proof counts crossings of the whole mesh together.
TEST(Injective, OneThingThatIsWrongWithALargeMeshIsNamedByAnyNumberOfThreads) {
  const test::Fixture square = test::square_grid(80);
  const int middle = 40 * 80 + 40;
  test::Fixture inverted = square, no_number = square, open = fan(9, 2, 0.1);
  inverted.rest.col(middle) += Vec2(1.3, 0.1);
  no_number.rest(1, middle) = std::nan("");
  open.triangles.conservativeResize(Eigen::NoChange, 8);
  for (const int threads : {1, 3}) {
    SCOPED_TRACE(testing::Message() << threads << " threads");
    Team team(threads);
    const WithTeam with(&team);
    const auto report_on = [](const test::Fixture& f) {
      return check_injectivity(f.triangles, f.rest);
    };
    EXPECT_TRUE(report_on(square).is_injective());
    EXPECT_TRUE(report_on(both(square, fan(9, 1, 0.1))).is_injective());
    EXPECT_GT(report_on(inverted).inverted, 0);
    EXPECT_EQ(report_on(inverted).degenerate, 0);
    EXPECT_GT(report_on(no_number).degenerate, 0);
    EXPECT_EQ(report_on(no_number).inverted, 0);
    const InjectivityReport covered_twice = report_on(both(square, fan(9, 2, 0.1)));
    EXPECT_EQ(covered_twice.branch_vertices, 1);
    EXPECT_EQ(covered_twice.first_branch_vertex, 80 * 80);
    const InjectivityReport overlapping = report_on(both(square, open));
    EXPECT_EQ(overlapping.overlapping_boundary_vertices, std::vector<int>{80 * 80});
    EXPECT_EQ(overlapping.branch_vertices, 0);
  }
}

// Against the sum of angles in floating point, on fans far from any tie.
TEST(Injective, AgreesWithTheAngleSum) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  int covers = 0;
  for (int i = 0; i < 2000; ++i) {
    const int turns = 1 + static_cast<int>(random() % 3);
    test::Fixture f = fan(8 + static_cast<int>(random() % 9), turns, 6 * unit(random));
    for (Eigen::Index v = 1; v < f.rest.cols(); ++v)
      f.rest.col(v) = f.rest.col(0) + (0.1 + unit(random)) * (f.rest.col(v) - f.rest.col(0));
    const InjectivityReport report = check_injectivity(f.triangles, f.rest);
    EXPECT_EQ(report.branch_vertices, turns > 1 ? 1 : 0);
    covers += report.branch_vertices;
  }
  EXPECT_GT(covers, 500);
}

}  // namespace
}  // namespace foldless
