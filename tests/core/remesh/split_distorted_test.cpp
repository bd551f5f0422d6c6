// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/split_distorted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/mesh/quality.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

double distortion(const MeshPair& mesh, int t) {
  return conformal_distortion(mesh.rest(), mesh.deformed(), mesh.triangles().col(t));
}

double largest_distortion(const MeshPair& mesh) {
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).max_conformal_distortion;
}

int distorted(const MeshPair& mesh, double least) {
  int count = 0;
  for (int t = 0; t < mesh.face_count(); ++t) count += distortion(mesh, t) >= least;
  return count;
}

/// Vertices of a grid moved at random, as far as no triangle folds.
MeshPair shaken_grid(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-0.08, 0.08);
  const Shape shape = grid({.columns = 6, .rows = 6, .width = 1, .height = 1});
  MeshPair mesh(shape.triangles, shape.rest);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Points u = mesh.deformed();
    u.col(v) += Vec2(unit(random), unit(random));
    if (is_injective(mesh.triangles(), mesh.rest(), u)) mesh.set_deformed(u);
  }
  return mesh;
}

TEST(SplitDistorted, SplitsOneEdgeOfEveryDistortedTriangleAndDoesNotChangeTheMap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MeshPair before = shaken_grid(seed);
    MeshPair mesh = before;
    const double least = 0.5 * largest_distortion(mesh);
    const int many = distorted(mesh, least);
    const int splits = split_distorted(mesh, least, {});
    EXPECT_GT(splits, 0);
    EXPECT_LE(splits, many) << "two of them may share an edge";
    EXPECT_EQ(mesh.vertex_count(), before.vertex_count() + splits);
    EXPECT_TRUE(is_injective(mesh.triangles(), mesh.rest(), mesh.deformed()));
    EXPECT_NEAR(largest_distortion(mesh), largest_distortion(before), 1e-9);
    for (int t = 0; t < before.face_count(); ++t) {
      const bool was_split = before.triangles().col(t) != mesh.triangles().col(t);
      EXPECT_TRUE(was_split || distortion(before, t) < least) << t;
    }
  }
}

TEST(SplitDistorted, TakesTheMostDistortedWhereThereIsRoomForFew) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MeshPair before = shaken_grid(seed);
    std::vector<int> triangles(static_cast<std::size_t>(before.face_count()));
    std::iota(triangles.begin(), triangles.end(), 0);
    std::ranges::sort(triangles, std::greater(), [&](int t) { return distortion(before, t); });
    for (const int most : {0, 1, 5}) {
      MeshPair mesh = before;
      EXPECT_EQ(split_distorted(mesh, 1, {.most_splits = most}), most);
      for (int i = 0; i < most; ++i) {
        const int t = triangles[static_cast<std::size_t>(i)];
        EXPECT_NE(before.triangles().col(t), mesh.triangles().col(t)) << i;
      }
    }
  }
}

TEST(SplitDistorted, LeavesWhatIsLessDistorted) {
  MeshPair mesh = shaken_grid(1);
  EXPECT_EQ(split_distorted(mesh, 1.01 * largest_distortion(mesh), {}), 0);
}

TEST(SplitDistorted, SplitsTheEdgeThatIsLongestInBothMeshesTogether) {
  // One triangle, ten times as wide as high at rest and five times as high as wide deformed.
  Triangles triangles(3, 1);
  triangles << 0, 1, 2;
  Points rest(2, 3), deformed(2, 3);
  rest << 0, 1, 0, 0, 0, 0.1;
  deformed << 0, 0.2, 0, 0, 0, 1;
  const auto first_split = [&](const Points& from, const Points& to) {
    MeshPair mesh(triangles, from, to);
    EXPECT_EQ(split_distorted(mesh, 1, {}), 1);
    return Vec2(mesh.rest().col(3));
  };
  EXPECT_EQ(first_split(rest, deformed), Vec2(0.5, 0.05)) << "the longest in neither alone";
  rest.row(1) *= 100;
  EXPECT_EQ(first_split(rest, deformed), Vec2(0.5, 5));
}

TEST(SplitDistorted, LeavesBoundaryEdgesBetweenFixedVertices) {
  const test::Fixture square = test::unit_square();
  const auto splits_with = [&](const std::vector<int>& fixed_boundary) {
    // Sheared along the diagonal between 1 and 3, or across it: of one of them it is the shortest.
    int splits = 0;
    for (const double shear : {-0.9, 0.9}) {
      MeshPair mesh(square.triangles, square.rest);
      Mat2 J;
      J << 1, shear, shear, 1;
      mesh.set_deformed(J * square.rest);
      splits += split_distorted(mesh, 10, {.fixed_boundary = fixed_boundary});
    }
    return splits;
  };
  EXPECT_EQ(splits_with({0, 1, 2, 3}), 2) << "the diagonal, of both";
  EXPECT_GT(splits_with({}), 2);
}

}  // namespace
}  // namespace foldless
