// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/compatible_triangulation.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/injective.h"
#include "core/mesh/winding.h"
#include "tests/support/all_triangulations.h"
#include "tests/support/glued_polygon.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

/// One of all triangulations is locally injective, by the proof that meshes get.
bool has_valid_triangulation(const Points& polygon) {
  const int corners = static_cast<int>(polygon.cols());
  for (const test::Pieces& pieces : test::all_triangulations(0, corners - 1))
    if (is_injective(test::as_triangles(pieces), polygon)) return true;
  return false;
}

TEST(BoundsDisk, ExactlyWhereOneOfAllTriangulationsIsLocallyInjective) {
  int disks = 0, overlapping = 0, others = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    Points polygon(2, 3 + static_cast<int>(seed % 6));
    // Few places, so that corners coincide and lie on lines.
    for (double& x : polygon.reshaped()) x = static_cast<double>(random() % (seed % 2 ? 4 : 50));
    const bool expected = has_valid_triangulation(polygon);
    ASSERT_EQ(bounds_disk(polygon), expected);
    (expected ? disks : others) += 1;
  }
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "glued, seed " << seed);
    std::mt19937_64 random(seed);
    const Points polygon = test::glued_polygon(random, 40);
    EXPECT_TRUE(bounds_disk(polygon));
    EXPECT_FALSE(bounds_disk(polygon.rowwise().reverse()));
    for (const auto& corner : polygon.colwise())
      if (least_winding_beside({polygon}, corner) > 0) ++overlapping;
  }
  EXPECT_GT(disks, 300) << "the claim would be empty";
  EXPECT_GT(others, 300) << "the claim would be empty";
  EXPECT_GT(overlapping, 300) << "the claim would be empty";
}

TEST(BoundsDisk, WithStraightCornersButNotWhereItGoesStraightBackOrTurnsTwice) {
  Points square(2, 8);
  square << 0, 1, 2, 2, 2, 1, 0, 0,  //
      0, 0, 0, 1, 2, 2, 2, 1;
  EXPECT_TRUE(bounds_disk(square));
  square.col(7) = Vec2(-1, 2);  // on the line of the side before it, and then to the left
  EXPECT_TRUE(bounds_disk(square));
  square.col(7) = Vec2(1.5, 2);  // back along it
  EXPECT_FALSE(bounds_disk(square));
  EXPECT_FALSE(bounds_disk(test::regular_polygon(7)(Eigen::all, {0, 2, 4, 6, 1, 3, 5})));
}

void expect_compatible(const MeshPair& mesh, const Points& rest, const Points& deformed) {
  EXPECT_TRUE(test::is_valid(mesh));
  const int corners = static_cast<int>(rest.cols());
  EXPECT_EQ(mesh.rest().leftCols(corners), rest);
  EXPECT_EQ(mesh.deformed().leftCols(corners), deformed);
  for (int i = 0; i < corners; ++i) {
    const auto side = mesh.find_edge(i, (i + 1) % corners);
    ASSERT_TRUE(side);
    EXPECT_TRUE(mesh.is_boundary_edge(*side));
  }
  for (int v = corners; v < mesh.vertex_count(); ++v) EXPECT_FALSE(mesh.is_boundary_vertex(v));
  EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), 1);
}

TEST(CompatibleTriangulation, MapsOneImmersedDiskOntoAnother) {
  int with_crossings = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const int corners = 4 + static_cast<int>(random() % 30);
    const Points rest = test::glued_polygon(random, corners);
    const Points deformed = test::glued_polygon(random, corners);
    const auto mesh = compatible_triangulation(rest, deformed);
    ASSERT_TRUE(mesh);
    expect_compatible(*mesh, rest, deformed);
    if (mesh->vertex_count() > corners) ++with_crossings;
  }
  EXPECT_GT(with_crossings, 200) << "the claim would be empty";
}

TEST(CompatibleTriangulation, AddsNoVertexWhereOnePolygonIsStrictlyConvex) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const int corners = 4 + static_cast<int>(random() % 40);
    const Points regular = test::regular_polygon(corners);
    const Points other = test::glued_polygon(random, corners);
    for (const auto& [rest, deformed] : {std::pair(regular, other), std::pair(other, regular)}) {
      const auto mesh = compatible_triangulation(rest, deformed);
      ASSERT_TRUE(mesh);
      expect_compatible(*mesh, rest, deformed);
      EXPECT_EQ(mesh->vertex_count(), corners);
    }
  }
}

TEST(CompatibleTriangulation, IsNothingWhereAPolygonBoundsNoDisk) {
  std::mt19937_64 random(1);
  const Points disk = test::glued_polygon(random, 9);
  const Points none = test::regular_polygon(9)(Eigen::all, {0, 2, 4, 6, 8, 1, 3, 5, 7});
  EXPECT_FALSE(compatible_triangulation(disk, none));
  EXPECT_FALSE(compatible_triangulation(none, disk));
}

}  // namespace
}  // namespace foldless
