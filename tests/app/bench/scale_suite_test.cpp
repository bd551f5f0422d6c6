// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/scale_suite.h"

#include <gtest/gtest.h>

#include "core/mesh/injective.h"

namespace foldless {
namespace {

TEST(ScaleSuite, TheSmallScenesHaveAboutTheTrianglesOfTheirNames) {
  for (const int index : {0, 1, 4, 5}) {
    const BenchScene scene = scale_scene(index);
    SCOPED_TRACE(scene.name);
    const double wanted = scene.name.ends_with("-20k") ? 20000 : 2000;
    EXPECT_NEAR(static_cast<double>(scene.scene.triangles.cols()), wanted, 0.05 * wanted);
    EXPECT_TRUE(is_injective(scene.scene.triangles, scene.scene.rest));
  }
}

TEST(ScaleSuite, AMillionTrianglesAreAMillion) {
  for (const int index : {9, 10}) {
    const BenchScene scene = scale_scene(index);
    SCOPED_TRACE(scene.name);
    EXPECT_TRUE(scene.name.ends_with("-1000k"));
    EXPECT_NEAR(static_cast<double>(scene.scene.triangles.cols()), 1e6, 1e4);
  }
}

TEST(ScaleSuite, ABendKeepsTheLengthOfTheEndThatMoves) {
  const Scene scene = scale_scene(0).scene;
  Points rest(2, 0), targets(2, 0);
  for (const Handle& handle : scene.handles) {
    if (scene.rest(0, handle.vertex) == 0) continue;
    rest.conservativeResize(2, rest.cols() + 1);
    targets.conservativeResize(2, targets.cols() + 1);
    rest.rightCols<1>() = scene.rest.col(handle.vertex);
    targets.rightCols<1>() = handle.target;
  }
  ASSERT_GT(rest.cols(), 2);
  EXPECT_NEAR((targets.rightCols<1>() - targets.col(0)).norm(),
              (rest.rightCols<1>() - rest.col(0)).norm(), 1e-12);
}

TEST(ScaleSuite, TheTableTellsTheExponentOfTheGrowth) {
  std::vector<BenchRow> rows(3);
  rows[0].scene = "bend-2k";
  rows[1].scene = "twist-2k";
  rows[2].scene = "bend-20k";
  for (BenchRow& row : rows) row.method = "foldless";
  rows[0].faces = 2000;
  rows[2].faces = 20000;
  rows[0].seconds = 0.1;
  rows[1].seconds = 7;
  rows[2].seconds = 1;
  const std::string csv = scale_table(rows).csv();
  EXPECT_NE(csv.find(",1.0,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace foldless
