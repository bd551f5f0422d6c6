// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/generate.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "tests/support/mesh_measures.h"

namespace foldless {
namespace {

using std::numbers::pi;
using test::area_of;
using test::boundary_vertex_count;
using test::euler_characteristic;
using test::min_angle;

constexpr DiskOptions kCoarse{.rings = 10, .boundary_vertices = 42, .vertices = 293};
constexpr DiskOptions kDense{.rings = 30, .boundary_vertices = 120, .vertices = 2483};

double polygon_area(int n) { return 0.5 * n * std::sin(2 * pi / n); }

TEST(Disk, HasTheSizesOfThePapersDisks) {
  const Shape coarse = disk(kCoarse), dense = disk(kDense);
  EXPECT_EQ(coarse.rest.cols(), 293);
  EXPECT_EQ(coarse.triangles.cols(), 542);
  EXPECT_EQ(dense.rest.cols(), 2483);
  EXPECT_EQ(dense.triangles.cols(), 4844);
}

TEST(Disk, IsOnePieceOfWellShapedTriangles) {
  for (const DiskOptions& options : {kCoarse, kDense}) {
    const Shape shape = disk(options);
    EXPECT_GT(min_angle(shape), 30);
    EXPECT_EQ(euler_characteristic(shape), 1);
    EXPECT_EQ(boundary_vertex_count(shape), options.boundary_vertices);
    EXPECT_NEAR(area_of(shape), polygon_area(options.boundary_vertices), 1e-12);
  }
}

TEST(Disk, EveryDiskThatIsNotRefusedIsFilledWithPositiveTriangles) {
  int made = 0;
  for (int rings = 1; rings <= 12; ++rings)
    for (int boundary = 3; boundary <= 60; boundary += 19)
      for (int extra = 0; extra <= 200; extra += 67) {
        const int inside = rings == 1 ? 0 : 3 * (rings - 1) + extra;
        const DiskOptions options{rings, boundary, 1 + inside + boundary, 2.5};
        SCOPED_TRACE(testing::Message() << rings << " " << boundary << " " << extra);
        try {
          const Shape shape = disk(options);
          EXPECT_EQ(shape.rest.cols(), options.vertices);
          EXPECT_EQ(shape.triangles.cols(), 2 * options.vertices - 2 - boundary);
          EXPECT_GT(min_angle(shape), 0);
          ++made;
        } catch (const Error&) {
          EXPECT_GT(rings, 1);
        }
      }
  EXPECT_GT(made, 80);
}

TEST(Disk, RingsAreCirclesOfTheRightRadius) {
  const Shape shape = disk(kCoarse);
  for (int ring = 0; ring <= kCoarse.rings; ++ring)
    for (const int v : disk_ring(kCoarse, ring))
      EXPECT_NEAR(shape.rest.col(v).norm(), 0.1 * ring, 1e-14);
}

TEST(Disk, RefusesOptionsThatContradictEachOther) {
  EXPECT_THROW(disk({.rings = 0}), Error);
  EXPECT_THROW(disk({.rings = 10, .boundary_vertices = 42, .vertices = 60}), Error);
  EXPECT_THROW(disk({.rings = 1, .boundary_vertices = 5, .vertices = 7}), Error);
  EXPECT_THROW(disk({.rings = 4, .boundary_vertices = 4, .vertices = 60}), Error);
  EXPECT_THROW(disk({.radius = 0}), Error);
  EXPECT_THROW(disk_ring({}, 11), Error);
}

TEST(Grid, HasTheSizesOfThePapersGrids) {
  for (const auto [cells, vertices, triangles] : {std::array{5, 36, 50}, {10, 121, 200}}) {
    const Shape shape = grid({.columns = cells, .rows = cells});
    EXPECT_EQ(shape.rest.cols(), vertices);
    EXPECT_EQ(shape.triangles.cols(), triangles);
  }
}

TEST(Grid, EveryDiagonalFillsTheRectangle) {
  for (const Diagonal d : {Diagonal::rising, Diagonal::falling, Diagonal::alternating}) {
    const Shape shape = grid({4, 3, 8, 6, d});
    EXPECT_NEAR(min_angle(shape), 45, 1e-9);
    EXPECT_DOUBLE_EQ(area_of(shape), 48);
    EXPECT_EQ(euler_characteristic(shape), 1);
  }
}

TEST(Grid, DiagonalsRunAsNamed) {
  const auto has = [](Diagonal d, int a, int b) {
    const Shape shape = grid({2, 1, 2, 1, d});
    return MeshPair(shape.triangles, shape.rest).find_edge(a, b).has_value();
  };
  EXPECT_TRUE(has(Diagonal::rising, 0, 4) && has(Diagonal::rising, 1, 5));
  EXPECT_TRUE(has(Diagonal::falling, 1, 3) && has(Diagonal::falling, 2, 4));
  EXPECT_TRUE(has(Diagonal::alternating, 0, 4) && has(Diagonal::alternating, 2, 4));
}

TEST(Grid, RefusesSizesThatAreNotPositive) {
  EXPECT_THROW(grid({.columns = 0}), Error);
  EXPECT_THROW(grid({.width = -1}), Error);
  EXPECT_THROW(bar(1, 1, 0), Error);
}

TEST(Bar, HasNearlySquareCells) {
  const Shape shape = bar(5, 1, 4);
  EXPECT_EQ(shape.triangles.cols(), 2 * 20 * 4);
  EXPECT_NEAR(area_of(shape), 5, 1e-12);
  EXPECT_NEAR(min_angle(shape), 45, 1e-9);
}

TEST(Annulus, IsARingOfWellShapedTriangles) {
  const Shape shape = annulus({});
  EXPECT_EQ(euler_characteristic(shape), 0);
  EXPECT_EQ(shape.rest.cols(), 7 * 48);
  EXPECT_NEAR(area_of(shape), (1 - 0.16) * polygon_area(48), 1e-12);
  EXPECT_GT(min_angle(shape), 30);
}

TEST(Annulus, RefusesRadiiThatDoNotIncrease) {
  EXPECT_THROW(annulus({.inner_radius = 1, .outer_radius = 1}), Error);
  EXPECT_THROW(annulus({.sectors = 2}), Error);
}

}  // namespace
}  // namespace foldless
