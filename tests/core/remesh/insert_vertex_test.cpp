// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/insert_vertex.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/mesh/injective.h"
#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

constexpr double kDelta = 1e-5;

MeshPair bent_grid(int n) {
  Fixture grid = square_grid(n);
  Points deformed = grid.rest;
  for (auto p : deformed.colwise()) p = Vec2(p.x() + 0.1 * p.y() * p.y(), 2 * p.y());
  return {grid.triangles, grid.rest, deformed};
}

int overlaps(const MeshPair& mesh) {
  return static_cast<int>(overlapping_boundary_vertices(mesh.triangles(), mesh.deformed()).size());
}

int shared_corners(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
  int count = 0;
  for (const int v : a) count += (b.array() == v).any() ? 1 : 0;
  return count;
}

TEST(InsertVertex, KeepsMapAndInjectivityAtRandomPoints) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::exponential_distribution<double> weight(1);
  MeshPair mesh = bent_grid(4);
  for (int k = 0; k < 300; ++k) {
    const int t = std::uniform_int_distribution<int>(0, mesh.face_count() - 1)(random);
    Eigen::Vector3d b(weight(random), weight(random), weight(random));
    b /= b.sum();
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    const Mat2 J = deformation_gradient(mesh.rest(), mesh.deformed(), corners);
    const int vertices = mesh.vertex_count();
    const int v = insert_vertex(mesh, t, b, kDelta);
    ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
    if (mesh.vertex_count() == vertices) {
      EXPECT_TRUE((corners.array() == v).any()) << "else a corner";
      continue;
    }
    for (const int round : mesh.triangles_of_vertex(v)) {
      const Eigen::Vector3i piece = mesh.triangles().col(round);
      if (shared_corners(piece, corners) < 2) continue;
      EXPECT_LT((deformation_gradient(mesh.rest(), mesh.deformed(), piece) - J).norm(), 1e-6);
    }
  }
  EXPECT_GT(mesh.vertex_count(), 100);
}

TEST(InsertVertex, SplitsTheEdgeWhereThePointIsBesideIt) {
  MeshPair mesh = bent_grid(3);
  const int faces = mesh.face_count();
  const int boundary = insert_vertex(mesh, 0, {0.5, 0.5, 0}, kDelta);
  EXPECT_EQ(mesh.face_count(), faces + 1);
  EXPECT_TRUE(mesh.is_boundary_vertex(boundary));
  const int inner = insert_vertex(mesh, 1, {0.49, 0.5, 0.01}, kDelta);
  EXPECT_EQ(mesh.triangles_of_vertex(inner).size(), 4U);
}

TEST(InsertVertex, CornerStandsForPointsBesideIt) {
  MeshPair mesh = bent_grid(3);
  const auto revision = mesh.revision();
  EXPECT_EQ(insert_vertex(mesh, 0, {0.97, 0.02, 0.01}, kDelta), mesh.triangles()(0, 0));
  EXPECT_EQ(insert_vertex(mesh, 0, {0, 0, 1}, kDelta), mesh.triangles()(2, 0));
  EXPECT_EQ(mesh.revision(), revision);
}

TEST(InsertVertex, DoesNotSplitWhatRoundingWouldFold) {
  Fixture f = unit_square();
  f.rest.col(2) = Vec2(1, std::nextafter(0.0, 1.0));
  f.rest.col(3) = Vec2(0, 1);
  MeshPair mesh(f.triangles, f.rest);
  ASSERT_TRUE(is_injective(mesh.triangles(), mesh.rest()));
  const int v = insert_vertex(mesh, 0, {0.4, 0.3, 0.3}, kDelta);
  EXPECT_LT(v, 4);
  EXPECT_EQ(mesh.face_count(), 2);
}

// A gap of a few units in the last place: where a split of its edges rounds to may close it.
TEST(InsertVertex, NoSplitClosesANarrowGapAtTheBoundary) {
  const Fixture fan = open_fan(300);
  const Vec2 shift(0.3, 0.7);
  int tried = 0, refused = 0;
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    const double angle = 0.1 + 0.002 * k, t = 0.1 + 0.0004 * k;
    const Eigen::Rotation2Dd turn(angle);
    Points narrow = turn.toRotationMatrix() * open_fan(360).rest;
    narrow.col(7) = 0.9 * narrow.col(1) + 3e-16 * Vec2(std::sin(angle), -std::cos(angle));
    narrow.colwise() += shift;
    MeshPair mesh(fan.triangles, fan.rest, narrow);
    if (overlaps(mesh) > 0) continue;
    ++tried;
    const bool at_first = k % 2 == 0;
    refused += insert_vertex(mesh, at_first ? 0 : 5,
                             at_first ? Eigen::Vector3d(1 - t, t, 0) : Eigen::Vector3d(1 - t, 0, t),
                             kDelta) != 8;
    EXPECT_EQ(overlaps(mesh), 0);
  }
  EXPECT_GT(tried, 1000) << "the claim would be empty";
  EXPECT_GT(refused, 10) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless::test
