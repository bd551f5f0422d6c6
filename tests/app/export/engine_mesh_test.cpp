// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/engine_mesh.h"

#include <gtest/gtest.h>

#include "tests/app/export/bent_grid.h"

namespace foldless {
namespace {

TEST(EngineMesh, CoordinatesAndTheirDifferencesAreExactInSinglePrecision) {
  for (const double pixel : {0.001, 0.0123, 7.7, 1e5}) {
    const BakedAnimation animation = test::grid_that_bends(true);
    const EngineUnits units{{1.5, 1.5}, pixel};
    const BakedAnimation held = in_pixels(animation, units);
    const Points& first = held.frames.front().deformed;
    for (std::size_t i = 0; i < held.frames.size(); ++i) {
      const Points& now = held.frames[i].deformed;
      const Points by = now - first;
      EXPECT_EQ(now, Points(now.cast<float>().cast<double>()));
      EXPECT_EQ(by, Points(by.cast<float>().cast<double>()));
      EXPECT_EQ(now, Points((first.cast<float>() + by.cast<float>()).cast<double>()));
      const Points exact = (animation.frames[i].deformed.colwise() - units.origin) / pixel;
      EXPECT_LT((now - exact).cwiseAbs().maxCoeff(), 2.5e-7 * exact.cwiseAbs().maxCoeff());
      EXPECT_NE(now, exact);
    }
  }
}

TEST(EngineMesh, TheLongestLoopComesFirstAndInOrder) {
  // A square of 3 × 3 cells without the one in its middle: the hole is no hull.
  BakedAnimation animation = test::grid_that_bends(false);
  std::vector<int> triangles;
  for (int t = 0; t < animation.triangles.cols(); ++t)
    if (t / 2 != 4) triangles.push_back(t);
  const EngineMesh mesh = engine_mesh(animation, triangles);
  ASSERT_EQ(mesh.hull, 12);
  ASSERT_EQ(mesh.vertices.size(), 16U);
  double area = 0;
  for (int i = 0; i < mesh.hull; ++i) {
    const auto at = [&](int k) {
      return Vec2(animation.rest.col(mesh.vertices[static_cast<std::size_t>(k % mesh.hull)]));
    };
    EXPECT_EQ((at(i + 1) - at(i)).norm(), 1) << "neighbours in the grid";
    area += 0.5 * cross(at(i), at(i + 1));
  }
  EXPECT_DOUBLE_EQ(area, 9);
  EXPECT_EQ(mesh.edges.size(), 32U);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(
          mesh.vertices[static_cast<std::size_t>(mesh.triangles(k, static_cast<Eigen::Index>(i)))],
          animation.triangles(k, triangles[i]));
}

TEST(EngineMesh, APieceHasItsOwnVerticesAlone) {
  const BakedAnimation animation = test::grid_that_bends(false);
  const EngineMesh mesh = engine_mesh(animation, {4, 5});
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.hull, 4);
  EXPECT_EQ(mesh.edges.size(), 5U);
  EXPECT_LT(mesh.triangles.maxCoeff(), 4);
}

TEST(EngineMesh, ARepeatedPictureIsMadeAWholeOneThatCoversTheDrawing) {
  const BakedAnimation animation = test::grid_that_bends(false);
  GltfPiece piece;
  piece.image = Image(2, 2);
  for (std::size_t p = 0; p < 4; ++p)  // By rows from the top.
    piece.image.pixels[4 * p] = static_cast<std::uint8_t>(p + 1);
  piece.place = {{0, 0}, {2.5, 2.5}};
  piece.is_tiled = true;
  const GltfPiece whole = without_tiles(animation, piece);
  EXPECT_FALSE(whole.is_tiled);
  EXPECT_EQ(whole.image.width, 3 * 32) << "three squares of 1.25 cover a length of 3";
  EXPECT_EQ(whole.place.max.x, 3.75);
  const auto square = [&](int column, int row) {  // From below.
    return int{whole.image.at(32 * column + 9, whole.image.height - 1 - (32 * row + 9))[0]};
  };
  EXPECT_EQ(square(0, 0), 3);
  EXPECT_EQ(square(1, 0), 4);
  EXPECT_EQ(square(0, 1), 1);
  EXPECT_EQ(square(1, 1), 2);
  EXPECT_EQ(square(2, 2), 3);
}

}  // namespace
}  // namespace foldless
