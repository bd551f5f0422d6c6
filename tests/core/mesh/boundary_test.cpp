// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/injective.h"
#include "core/mesh/mesh_pair.h"
#include "tests/support/meshes.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

/// The fan somewhere, turned, with sides of other lengths.
test::Fixture random_fan(double angle, int triangles, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  test::Fixture f = test::open_fan(angle / std::numbers::pi * 180, triangles);
  f.rest = Eigen::Rotation2Dd(7 * unit(random)).toRotationMatrix() * f.rest;
  for (int k = 1; k < f.rest.cols(); ++k) f.rest.col(k) *= 0.1 + unit(random);
  f.rest.colwise() += test::random_vector(unit, random);
  return f;
}

long double angle_sum(const test::Fixture& f, int v) {
  long double sum = 0;
  for (const auto& t : f.triangles.colwise())
    for (int corner = 0; corner < 3; ++corner) {
      if (t[corner] != v) continue;
      const Eigen::Vector2<long double> o = f.rest.col(v).cast<long double>();
      const Eigen::Vector2<long double> a = f.rest.col(t[(corner + 1) % 3]).cast<long double>() - o;
      const Eigen::Vector2<long double> b = f.rest.col(t[(corner + 2) % 3]).cast<long double>() - o;
      sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
  return sum;
}

TEST(Boundary, RunsRoundAGridWithTheMeshOnItsLeft) {
  const int n = 5;
  const test::Fixture f = test::square_grid(n);
  const auto neighbours = boundary_neighbours(f.triangles, n * n + 1);
  int v = 0, length = 0;
  do {
    const int next = neighbours[static_cast<std::size_t>(v)].next;
    ASSERT_GE(next, 0);
    EXPECT_EQ(neighbours[static_cast<std::size_t>(next)].previous, v);
    v = next;
    ++length;
  } while (v != 0 && length < 100);
  EXPECT_EQ(length, 4 * (n - 1));
  EXPECT_EQ(neighbours[0].next, 1) << "counter-clockwise";
  EXPECT_FALSE(neighbours[n + 1].are_there()) << "inside";
  EXPECT_FALSE(neighbours[n * n].are_there()) << "a vertex without a triangle";
}

TEST(Boundary, ALoopBeginsAtTheVertexThatIsNamedAndHasEveryOtherOnce) {
  const int n = 4;
  const test::Fixture f = test::square_grid(n);
  const std::vector<int> loop = boundary_loop(boundary_neighbours(f.triangles, n * n), 3);
  EXPECT_EQ(loop, (std::vector<int>{3, 7, 11, 15, 14, 13, 12, 8, 4, 0, 1, 2}));
}

TEST(Boundary, NeighboursStayThroughFlips) {
  const test::Fixture f = test::square_grid(6);
  MeshPair mesh(f.triangles, f.rest);
  const auto before = boundary_neighbours(mesh.triangles(), 36);
  int flips = 0;
  for (int e = 0; e < mesh.edge_count(); ++e)
    if (mesh.is_flip_legal(e) && e % 3 == 0) {
      mesh.flip(e);
      ++flips;
    }
  ASSERT_GT(flips, 10);
  const auto after = boundary_neighbours(mesh.triangles(), 36);
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_EQ(before[v].next, after[v].next);
    EXPECT_EQ(before[v].previous, after[v].previous);
  }
}

// Squares of such indices are beyond 2⁶² and their sums beyond 2⁶³.
TEST(Boundary, FindsTheEndsOfAChainOfLargeIndices) {
  constexpr int kLarge = 2147483647;
  LinkEnds ends;
  for (int k = 0; k < 9; ++k) ends.add(kLarge - 1 - 2 * ((5 * k) % 9), k);
  for (int k = 0; k < 8; ++k) ends.add(k, kLarge - 1 - 2 * ((5 * k + 5) % 9));
  EXPECT_EQ(ends.neighbours().next, kLarge - 1);
  EXPECT_EQ(ends.neighbours().previous, 8);
}

// Away from a full turn, where the sum of angles can be trusted.
TEST(Boundary, OverlapsAreWhereTheAnglesAddUpToAFullTurn) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  int overlaps = 0;
  for (int i = 0; i < 4000; ++i) {
    const double angle = (0.2 + 5.6 * unit(random)) * std::numbers::pi;
    const int least = static_cast<int>(angle / 3) + 1;
    const test::Fixture f = random_fan(angle, least + static_cast<int>(random() % 9), random);
    const long double sum = angle_sum(f, 0);
    ASSERT_NEAR(static_cast<double>(sum), angle, 1e-9);
    if (std::abs(sum - 2 * kPi) < 1e-9L) continue;
    const InjectivityReport report = check_injectivity(f.triangles, f.rest);
    ASSERT_TRUE(report.is_injective_inside());
    const std::vector<int> expected = sum > 2 * kPi ? std::vector<int>{0} : std::vector<int>{};
    EXPECT_EQ(report.overlapping_boundary_vertices, expected) << angle;
    EXPECT_EQ(report.is_injective(), expected.empty());
    std::vector<Eigen::Vector3i> fan;
    for (const auto& t : f.triangles.colwise()) fan.emplace_back(t);
    std::shuffle(fan.begin(), fan.end(), random);
    EXPECT_EQ(overlaps_itself(0, fan, f.rest), !expected.empty()) << angle;
    overlaps += static_cast<int>(expected.size());
  }
  EXPECT_GT(overlaps, 1000);
}

// One unit in the last place decides.
TEST(Boundary, AGapThatIsClosedCountsAsOverlapAndTheNarrowestOpenOneDoesNot) {
  const Vec2 v(0.5, -0.25), first(1, 0.5);
  std::mt19937 random(3);
  test::Fixture f = random_fan(6, 8, random);
  f.rest.col(0) = v;
  for (int k = 0; k < 8; ++k)
    f.rest.col(k + 1) =
        v + Vec2(Eigen::Rotation2Dd(k * std::numbers::pi / 4) * (k == 0 ? first : 3 * first));
  f.rest.col(1) = v + first;
  f.rest.col(9) = v + 2 * first;
  EXPECT_EQ(overlapping_boundary_vertices(f.triangles, f.rest), std::vector<int>{0});
  const double closed = f.rest(1, 9);
  f.rest(1, 9) = std::nextafter(closed, -1.0);
  EXPECT_TRUE(overlapping_boundary_vertices(f.triangles, f.rest).empty());
  f.rest(1, 9) = std::nextafter(closed, 1.0);
  EXPECT_EQ(overlapping_boundary_vertices(f.triangles, f.rest), std::vector<int>{0});
}

TEST(Boundary, VerticesWithAFoldedTriangleAreNotCounted) {
  std::mt19937 random(5);
  test::Fixture f = random_fan(5 * std::numbers::pi, 12, random);
  ASSERT_EQ(overlapping_boundary_vertices(f.triangles, f.rest).size(), 1u);
  f.rest.col(4) = f.rest.col(0) - (f.rest.col(4) - f.rest.col(0));
  ASSERT_GT(check_injectivity(f.triangles, f.rest).inverted, 0);
  EXPECT_TRUE(overlapping_boundary_vertices(f.triangles, f.rest).empty());
}

}  // namespace
}  // namespace foldless
