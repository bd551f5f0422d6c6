// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/mesh_place.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

/// A 3 × 3 grid, 100 pixels a cell, seen from the middle.
class PlaceAt : public testing::Test {
 protected:
  PlaceAt() {
    canvas_.camera = {{1, 1}, 100};
    canvas_.width = canvas_.height = 400;
  }
  std::optional<MeshPlace> at(double x, double y) {
    return place_at(grid_.triangles, grid_.rest, canvas_, canvas_.to_pixel({x, y}));
  }
  Fixture grid_ = square_grid(3);
  Canvas canvas_;
};

TEST_F(PlaceAt, FindsVerticesEdgesAndTriangles) {
  EXPECT_EQ(at(1.02, 1.01)->corners, std::vector{4});
  EXPECT_EQ(at(0.5, 1.01)->corners, (std::vector{3, 4}));
  EXPECT_EQ(at(0.51, 0.5)->corners, (std::vector{0, 4})) << "a diagonal";
  const auto triangle = at(0.7, 0.3);
  ASSERT_TRUE(triangle);
  EXPECT_EQ(triangle->corners, (std::vector{0, 1, 4}));
  EXPECT_EQ(triangle->triangle, 0);
}

TEST_F(PlaceAt, IsNothingOutsideTheMesh) { EXPECT_FALSE(at(2.2, 1)); }

TEST_F(PlaceAt, LeavesTheMiddleOfSmallTrianglesToThem) {
  canvas_.camera.pixels_per_unit = 8;
  EXPECT_EQ(at(0.7, 0.3)->corners.size(), 3U);
}

TEST_F(PlaceAt, SaysWhatRemeshingHasMade) {
  Snapshot snapshot;
  snapshot.triangles = std::make_shared<const Triangles>(grid_.triangles);
  snapshot.rest = std::make_shared<const Points>(grid_.rest);
  snapshot.deformed = 2 * grid_.rest;
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(std::vector<Edge>{{0, 4}});
  snapshot.original_vertices = 8;
  EXPECT_EQ(words_of({0, {0, 4}}, snapshot), "Edge 0–4, flipped");
  EXPECT_EQ(words_of({0, {0, 1}}, snapshot), "Edge 0–1");
  EXPECT_EQ(words_of({0, {8}}, snapshot), "Vertex 8, made by a split");
  EXPECT_EQ(words_of({0, {7, 8}}, snapshot), "Edge 7–8, made by a split");
  EXPECT_EQ(words_of({0, {0, 1, 4}}, snapshot), "Triangle 0: A′/A 4, σ₁/σ₂ 1");
}

}  // namespace
}  // namespace foldless::test
