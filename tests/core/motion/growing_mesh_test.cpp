// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/growing_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// A triangle that a vertex near its lower edge parts in three; that below is thin.
GrowingMesh with_thin_triangle() {
  Triangles triangle(3, 1);
  triangle << 0, 1, 2;
  Points rest(2, 3);
  rest << 0, 1, 0.5,  //
      0, 0, 1;
  GrowingMesh mesh(triangle, rest);
  EXPECT_EQ(mesh.split_triangle(0, {0.5, 1e-3}).size(), 3U);
  return mesh;
}

double area(const GrowingMesh& mesh) {
  double sum = 0;
  for (int t = 0; t < mesh.face_count(); ++t) {
    const double of_triangle = signed_area(mesh.rest(), mesh.triangle(t));
    EXPECT_GT(of_triangle, 0) << t;
    sum += of_triangle;
  }
  return sum;
}

TEST(GrowingMesh, AnEdgeIsFlippedWhereThatMakesTrianglesLessThin) {
  GrowingMesh mesh = with_thin_triangle();
  // A vertex right above the thin triangle's upper edge: that is flipped away.
  ASSERT_FALSE(mesh.split_edge(0, 3, {0.25, 0.5e-3}).empty());
  ASSERT_FALSE(mesh.split_edge(2, 3, {0.5, 0.6}).empty());
  const double before = area(mesh);
  const std::vector<int> changed = mesh.flip_edge(4, 2);
  ASSERT_EQ(changed.size(), 2U);
  EXPECT_NEAR(area(mesh), before, 1e-15);
  for (const int t : changed) EXPECT_EQ(mesh.origin(t), 0);
  // The other diagonal has come, so that the first is no edge any more.
  EXPECT_TRUE(mesh.split_edge(4, 2, {0.3, 0.2}).empty());
  EXPECT_TRUE(mesh.flip_edge(0, 5).empty()) << "that would be the worse one again";
}

TEST(GrowingMesh, AnEdgeOfTheDrawingStays) {
  const test::Fixture f = test::unit_square();
  GrowingMesh mesh(f.triangles, f.rest);
  EXPECT_TRUE(mesh.flip_edge(0, 2).empty()) << "between two of its triangles";
  EXPECT_TRUE(mesh.flip_edge(0, 1).empty()) << "at its boundary";
}

TEST(GrowingMesh, NeedlesAreNotMade) {
  GrowingMesh mesh = with_thin_triangle();
  EXPECT_TRUE(mesh.split_triangle(0, {0.5, 1e-9}).empty());
  EXPECT_EQ(mesh.vertex_count(), 4);
  EXPECT_DOUBLE_EQ(area(mesh), 0.5);
}

}  // namespace
}  // namespace foldless
