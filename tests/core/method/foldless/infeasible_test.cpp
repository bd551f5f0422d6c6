// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/infeasible.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "core/construct/compatible_triangulation.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// What is said when the boundary of `mesh` and the vertices of `inside` go to `targets`, given by
/// vertex; empty when nothing is.
std::string said_of(const MeshPair& mesh, const std::vector<int>& inside, const Points& targets) {
  std::vector<Handle> handles;
  const auto add = [&](int v) {
    handles.push_back({.id = v, .vertex = v, .target = targets.col(v)});
  };
  for (const int v : inside) add(v);
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v)) add(v);
  const Constraints constraints = constraints_of(handles);
  return why_infeasible(prescribed_regions(mesh, constraints), constraints).value_or("");
}

/// Vertices (i, j) of [0, 3]² with index 4 j + i; 5, 6, 9 and 10 are inside.
MeshPair square() {
  const test::Fixture grid = test::square_grid(4);
  return {grid.triangles, grid.rest};
}

std::string said_of_square(const std::vector<std::pair<int, Vec2>>& moved) {
  const MeshPair mesh = square();
  Points targets = mesh.rest();
  std::vector<int> inside;
  for (const auto& [v, target] : moved) {
    targets.col(v) = target;
    if (!mesh.is_boundary_vertex(v)) inside.push_back(v);
  }
  return said_of(mesh, inside, targets);
}

TEST(WhyInfeasible, AVertexMayNotLeaveTheHeldBoundaryNorMeetIt) {
  for (const Vec2& target : {Vec2(4, 1), Vec2(-0.001, 2), Vec2(1, 0), Vec2(3, 1.5), Vec2(0, 0)})
    EXPECT_EQ(said_of_square({{6, target}}),
              "infeasible: vertex 6 is to go out of the held boundary, or onto it");
  EXPECT_EQ(said_of_square({{6, {0.001, 2.999}}}), "");
}

TEST(WhyInfeasible, VerticesMayNotMeetMoreOftenThanTheBoundaryGoesRound) {
  EXPECT_EQ(said_of_square({{10, {1.2, 1.1}}, {5, {1.2, 1.1}}}),
            "infeasible: vertices 10 and 5 are to go to the same point, which the held boundary "
            "goes round once");
  EXPECT_EQ(said_of_square({{10, {1.2, 1.1}}, {5, {1.2, std::nextafter(1.1, 2)}}}), "");
}

TEST(WhyInfeasible, NeighboursAlongTheBoundaryMayNotMeet) {
  EXPECT_EQ(said_of_square({{1, {0, 0}}}),
            "infeasible: vertices 0 and 1, neighbours along the boundary, are to go to the same "
            "point");
}

TEST(WhyInfeasible, TheBoundaryMayNotBeTurnedOver) {
  const MeshPair mesh = square();
  Points mirrored = mesh.rest();
  mirrored.row(0) *= -1;
  EXPECT_EQ(said_of(mesh, {}, mirrored),
            "infeasible: the held boundary with vertex 0 is to go the wrong way round");
}

TEST(WhyInfeasible, TheBoundaryMayNotCrossItselfToAFigureOfEight) {
  // The last column turned over: the upper right corner goes below the lower right one.
  EXPECT_EQ(said_of_square({{3, {3, 2}}, {7, {3.1, 1.5}}, {11, {3.1, 1.4}}, {15, {3, 1}}}),
            "infeasible: the held boundary with vertex 0 is to turn 0 times, and must turn once");
}

TEST(WhyInfeasible, TheBoundaryOfADiskMayNotTurnTwice) {
  const Shape shape = disk({.rings = 4, .boundary_vertices = 20, .vertices = 53, .radius = 1});
  const MeshPair mesh(shape.triangles, shape.rest);
  Points targets = shape.rest;
  for (auto p : targets.colwise()) {
    const double angle = std::atan2(p.y(), p.x());
    p = (2 + std::cos(angle)) * Vec2(std::cos(2 * angle), std::sin(2 * angle));
  }
  const std::string said = said_of(mesh, {}, targets);
  EXPECT_NE(said.find("is to turn 2 times, and must turn once"), std::string::npos) << said;
}

TEST(WhyInfeasible, TheBoundaryMayNotGoStraightBack) {
  EXPECT_EQ(said_of_square({{2, {2.5, 0}}, {3, {2.25, 0}}, {7, {3, 1}}}),
            "infeasible: the held boundary with vertex 0 is to go straight back at vertex 2");
  EXPECT_EQ(said_of_square({{2, {2.5, 0}}, {3, {2.5, -1}}}), "");
}

TEST(WhyInfeasible, ACurveThatTurnsOnceAndWindsNowhereNegativelyMayBoundNoDisk) {
  int only_so = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair mesh = square();
    Points targets = mesh.rest();
    for (int v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.is_boundary_vertex(v))
        targets.col(v) +=
            Vec2(static_cast<double>(random() % 7), static_cast<double>(random() % 7));
    const std::string said = said_of(mesh, {}, targets);
    const std::vector<int> loop{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4};
    EXPECT_EQ(said.empty(), bounds_disk(targets(Eigen::all, loop)));
    if (said.find("is to cross itself so that it bounds no disk") != std::string::npos) ++only_so;
  }
  EXPECT_GT(only_so, 5) << "the claim would be empty";
}

TEST(WhyInfeasible, AHoleMayNotLeaveItsSurroundings) {
  const AnnulusOptions options{.sectors = 12, .layers = 3};
  const Shape shape = annulus(options);
  const MeshPair mesh(shape.triangles, shape.rest);
  Points targets = shape.rest;
  EXPECT_EQ(said_of(mesh, {}, targets), "");
  targets.leftCols(options.sectors).colwise() += Vec2(3, 0.1);
  EXPECT_NE(said_of(mesh, {}, targets).find("the wrong way round points beside vertex"),
            std::string::npos);
}

TEST(WhyInfeasible, NothingIsSaidWhereAVertexOfTheBoundaryIsFreeOrSoft) {
  const MeshPair mesh = square();
  std::vector<Handle> handles{{.id = 0, .vertex = 5, .target = Vec2(9, 9)}};
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v))
      handles.push_back({.id = v + 1, .vertex = v, .target = mesh.rest().col(v)});
  const auto said = [&] {
    const Constraints constraints = constraints_of(handles);
    return why_infeasible(prescribed_regions(mesh, constraints), constraints).has_value();
  };
  EXPECT_TRUE(said());
  handles.back().kind = HandleKind::soft;
  EXPECT_FALSE(said());
  handles.pop_back();
  EXPECT_FALSE(said());
}

/// Vertices inside, each with a chance of a half.
std::vector<int> some_inside(const MeshPair& mesh, std::mt19937_64& random) {
  std::vector<int> inside;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_boundary_vertex(v) && random() % 2 == 0) inside.push_back(v);
  return inside;
}

/// Nothing may be said of the targets that a locally injective map takes, nor of the same turned.
void expect_feasible(const MeshPair& mesh, std::mt19937_64& random) {
  ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()))
      << "the claim is about locally injective maps";
  const std::vector<int> inside = some_inside(mesh, random);
  EXPECT_EQ(said_of(mesh, inside, mesh.deformed()), "");
  std::uniform_real_distribution<double> angle(0, 2 * kHalfTurn);
  const Points turned = Eigen::Rotation2Dd(angle(random)).toRotationMatrix() * mesh.deformed();
  EXPECT_TRUE(!is_injective(mesh.triangles(), turned, turned) ||
              said_of(mesh, inside, turned).empty());
}

TEST(WhyInfeasible, IsNeverSaidOfRandomMaps) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const test::OwnWorkspace own = test::arrived_workspace(seed, static_cast<int>(seed % 3) * 10);
    ASSERT_NO_FATAL_FAILURE(expect_feasible(own.work.mesh, random));
  }
}

TEST(WhyInfeasible, IsNeverSaidOfStripsWoundUp) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const Shape shape = bar(20, 1, 2);
    // Half of them go round the same circle, the others along a spiral that may cross itself.
    const double per_length = 4.5 * kHalfTurn / 20 * unit(random);
    const double growth = seed % 2 == 0 ? 0 : 0.05 * unit(random);
    Points wound = shape.rest;
    for (auto p : wound.colwise()) {
      const double radius = 3 - p.y() + growth * p.x(), angle = per_length * p.x();
      p = radius * Vec2(std::cos(angle), std::sin(angle));
    }
    ASSERT_NO_FATAL_FAILURE(expect_feasible(MeshPair(shape.triangles, shape.rest, wound), random));
  }
}

TEST(WhyInfeasible, IsNeverSaidOfAnAnnulusWoundTwiceRoundItself) {
  const AnnulusOptions options{.sectors = 48, .layers = 4};
  const Shape shape = annulus(options);
  Points doubled = shape.rest;
  for (int v = 0; v < static_cast<int>(doubled.cols()); ++v) {
    // Vertices half a circle apart go to exactly the same point.
    const int like = v % options.sectors < options.sectors / 2 ? v : v - options.sectors / 2;
    const Vec2 p = shape.rest.col(like);
    const double angle = 2 * std::atan2(p.y(), p.x());
    doubled.col(v) = p.norm() * Vec2(std::cos(angle), std::sin(angle));
  }
  std::mt19937_64 random(1);
  ASSERT_NO_FATAL_FAILURE(expect_feasible(MeshPair(shape.triangles, shape.rest, doubled), random));
}

TEST(WhyInfeasible, IsSaidOfABoundaryAngleOfMoreThanAFullTurnUnlessAnotherMapHasLess) {
  // A fan round vertex 0 of the boundary, spread out to up to three turns: it turns as often as a
  // disk must exactly where the angle is less than one; to exactly one or two every fourth time.
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const int n = 24;
    const double turns = seed % 4 == 0 ? 1 + static_cast<double>(seed / 4 % 2) : 3 * unit(random);
    Points rest(2, n + 2), spread(2, n + 2);
    rest.col(0).setZero();
    spread.col(0) = Vec2(0.3, 0.1);
    Triangles triangles(3, n);
    for (int k = 0; k <= n; ++k) {
      const double part = static_cast<double>(k) / n;
      rest.col(k + 1) = Vec2(std::cos(3 * part), std::sin(3 * part));
      const double angle = 2 * kHalfTurn * turns * part;
      spread.col(k + 1) =
          spread.col(0) + (0.5 + unit(random)) * Vec2(std::cos(angle), std::sin(angle));
      if (k < n) triangles.col(k) << 0, k + 1, k + 2;
    }
    if (seed % 4 == 0) spread.col(n + 1) = spread.col(1);
    const MeshPair mesh(triangles, rest, spread);
    if (turns < 1)
      ASSERT_NO_FATAL_FAILURE(expect_feasible(mesh, random));
    else
      EXPECT_NE(said_of(mesh, {}, spread), "");
  }
}

}  // namespace
}  // namespace foldless
