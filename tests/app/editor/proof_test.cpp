// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/proof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

Snapshot pose_of(const Fixture& fixture, Points deformed) {
  Snapshot pose;
  pose.triangles = std::make_shared<const Triangles>(fixture.triangles);
  pose.rest = std::make_shared<const Points>(fixture.rest);
  pose.deformed = std::move(deformed);
  pose.original_vertices = static_cast<int>(fixture.rest.cols());
  return pose;
}

TEST(Proof, HoldsForAMeshThatIsStretched) {
  const Fixture grid = square_grid(4);
  Points stretched = grid.rest;
  stretched.row(0) *= 0.5;
  const Proof proof = proof_of(pose_of(grid, stretched));
  EXPECT_TRUE(proof.holds());
  EXPECT_EQ(proof.triangles, 18);
  EXPECT_EQ(proof.vertices, 16);
  EXPECT_DOUBLE_EQ(proof.min_area_ratio, 0.5);
  EXPECT_NEAR(proof.max_conformal_distortion, 2, 1e-12);
  EXPECT_EQ(fold_words(proof), "");
}

TEST(Proof, CountsATriangleThatIsTurnedOver) {
  const Fixture square = unit_square();
  Points folded = square.rest;
  folded.col(3) = Vec2(0.75, 0.25);
  const Proof proof = proof_of(pose_of(square, folded));
  EXPECT_FALSE(proof.holds());
  EXPECT_EQ(proof.inverted, 1);
  EXPECT_DOUBLE_EQ(proof.min_area_ratio, -0.5);
  EXPECT_EQ(fold_words(proof), "This map folds: 1 triangle is inverted");
}

TEST(Proof, IsExactWhereATriangleHasNoArea) {
  const Fixture square = unit_square();
  Points flat = square.rest;
  flat.col(3) = Vec2(0.5, 0.5);
  EXPECT_EQ(proof_of(pose_of(square, flat)).inverted, 1);
  flat.col(3) = Vec2(0.5, std::nextafter(0.5, 1));
  EXPECT_TRUE(proof_of(pose_of(square, flat)).holds());
}

TEST(Proof, SeesAVertexThatIsWoundTwice) {
  const Fixture rim = hexagon();
  Points wound = rim.rest;
  for (int k = 0; k < 6; ++k) {
    const double angle = 2 * k * std::numbers::pi / 3;
    wound.col(k + 1) = Vec2(std::cos(angle), std::sin(angle));
  }
  const Proof proof = proof_of(pose_of(rim, wound));
  EXPECT_EQ(proof.inverted, 0) << "every triangle alone is as it should be";
  EXPECT_EQ(proof.branch_vertices, 1);
  EXPECT_FALSE(proof.holds());
  EXPECT_EQ(fold_words(proof), "This map folds: 1 vertex is wound twice");
}

TEST(Proof, SeesABoundaryVertexThatOverlapsItself) {
  const Fixture fan = open_fan(300);
  EXPECT_TRUE(proof_of(pose_of(fan, fan.rest)).holds());
  const Proof proof = proof_of(pose_of(fan, open_fan(400).rest));
  EXPECT_EQ(proof.overlapping_boundary_vertices, 1);
  EXPECT_FALSE(proof.holds());
  EXPECT_FALSE(proof.folds()) << "such a map may be kept";
  EXPECT_EQ(fold_words(proof), "1 boundary vertex overlaps itself");
}

}  // namespace
}  // namespace foldless::test
