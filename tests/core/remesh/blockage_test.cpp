// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/blockage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/mesh/orientation.h"
#include "tests/core/remesh/one_ring.h"

namespace foldless {
namespace {

using test::kEast;

std::vector<Edge> blocking_edges(const MeshPair& mesh, const Blockage& blockage) {
  std::vector<Edge> edges;
  for (const int e : blockage.blocking) edges.push_back(mesh.edge(e));
  return edges;
}

std::vector<Edge> split_edges_of(const MeshPair& mesh, const Blockage& blockage) {
  std::vector<Edge> edges;
  for (const EdgeSplit& split : blockage.splits) edges.push_back(mesh.edge(split.edge));
  return edges;
}

TEST(Blockage, InsideOneEdgeSplitsThatEdge) {
  const MeshPair mesh = test::figure_4a();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_EQ(blockage.v_alpha, Vec2(1, 0));
  EXPECT_EQ(blocking_edges(mesh, blockage), std::vector<Edge>({{1, 2}}));
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{1, 2}}));
}

TEST(Blockage, OutsideOneEdgeSplitsTheSpokeToItsFarEnd) {
  const MeshPair mesh = test::figure_4b();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_NEAR((blockage.v_alpha - Vec2(1, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(blocking_edges(mesh, blockage), std::vector<Edge>({{3, 4}}));
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{0, 4}}));
}

TEST(Blockage, AtACommonEndSplitsFourEdges) {
  const MeshPair mesh = test::one_ring({{0, -2}, {1, 0}, {0, 2}, {-1, 0}});
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_EQ(blockage.v_alpha, Vec2(1, 0));
  std::vector<Edge> splits = split_edges_of(mesh, blockage);
  std::ranges::sort(splits);
  EXPECT_EQ(splits, std::vector<Edge>({{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
}

TEST(Blockage, ComponentsAreSplitFromTheFarthestToTheNearest) {
  const MeshPair mesh = test::figure_16();
  const Blockage blockage = blockage_of(mesh, 0, kEast).value();
  EXPECT_NEAR((blockage.v_alpha - Vec2(1, 0)).norm(), 0, 1e-15);
  std::vector<Edge> blocking = blocking_edges(mesh, blockage);
  std::ranges::sort(blocking);
  EXPECT_EQ(blocking, std::vector<Edge>({{1, 7}, {3, 4}, {6, 7}}));
  // {3–4} is 2 away from v_α, {6–7, 7–1} is 1 away.
  EXPECT_EQ(split_edges_of(mesh, blockage), std::vector<Edge>({{0, 4}, {0, 6}, {0, 7}}));
}

TEST(Blockage, NothingBlocksAVertexThatNoTriangleEndsBefore) {
  // A lone triangle: away from its opposite edge the vertex may go for ever.
  Points points(2, 3);
  points << 0, -1, -1,  //
      0, 1, -1;
  const MeshPair mesh(Triangles(Eigen::Vector3i(0, 1, 2)), points);
  EXPECT_FALSE(blockage_of(mesh, 0, kEast).has_value());
  EXPECT_TRUE(blockage_of(mesh, 0, -kEast).has_value());
}

/// A closed link round the origin at random, seen from there as a whole.
MeshPair random_ring(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec2> link;
  const int n = 4 + static_cast<int>(random() % 6);
  for (int k = 0; k < n; ++k) {
    const double angle = 6.28318 * (k + 0.8 * unit(random)) / n;
    link.push_back((0.3 + unit(random)) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return test::one_ring(link);
}

/// True when vertex 0 may sit there while all others stand still.
bool is_open_at(const MeshPair& mesh, const Vec2& place) {
  Points u = mesh.deformed();
  u.col(0) = place;
  return is_injective(mesh.triangles(), u);
}

/// One of the cases of 4.4 in so many of random rings.
struct Cases {
  int inside = 0, outside = 0;
};

/// A vertex and its first fold: what eq. 13 and the appendix say of it, without lines.
void expect_first_fold(const MeshPair& mesh, const Vec2& direction, Cases& cases) {
  const Blockage blockage = blockage_of(mesh, 0, direction).value();
  const double reach = blockage.v_alpha.norm();
  EXPECT_NEAR(blockage.v_alpha.dot(direction), reach, 1e-12 * reach);
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(is_open_at(mesh, k / 100.0 * blockage.v_alpha)) << k;
  EXPECT_TRUE(is_open_at(mesh, (1 - 1e-9) * blockage.v_alpha));
  EXPECT_FALSE(is_open_at(mesh, (1 + 1e-9) * blockage.v_alpha));
  // The triangle that folds there.
  Points u = mesh.deformed();
  u.col(0) = (1 + 1e-9) * blockage.v_alpha;
  std::vector<Edge> folded;
  Edge edge{};
  for (const auto& t : mesh.triangles().colwise())
    if (orientation(u, t) <= 0) {
      edge = {std::min(t[1], t[2]), std::max(t[1], t[2])};
      folded.push_back(edge);
    }
  ASSERT_EQ(folded.size(), 1U);
  EXPECT_EQ(blocking_edges(mesh, blockage), folded);
  // v_α is inside the edge, or nearer to one end, which the spoke to the other sweeps across.
  const double a = (mesh.deformed().col(edge[0]) - blockage.v_alpha).norm();
  const double b = (mesh.deformed().col(edge[1]) - blockage.v_alpha).norm();
  const double length = (mesh.deformed().col(edge[0]) - mesh.deformed().col(edge[1])).norm();
  ASSERT_EQ(blockage.splits.size(), 1U);
  const Edge split = mesh.edge(blockage.splits[0].edge);
  if (a < length && b < length) {
    ++cases.inside;
    EXPECT_EQ(split, edge);
    EXPECT_NEAR(blockage.splits[0].at, std::clamp(a / length, 0.2, 0.8), 1e-9);
  } else {
    ++cases.outside;
    EXPECT_EQ(split, (Edge{0, a > b ? edge[0] : edge[1]}));
    EXPECT_EQ(blockage.splits[0].at, 0.5);
  }
}

TEST(Blockage, IsWhereTheFirstTriangleFolds) {
  Cases cases;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const MeshPair mesh = random_ring(random);
    const double angle = static_cast<double>(random() % 6283) / 1000;
    expect_first_fold(mesh, Vec2(std::cos(angle), std::sin(angle)), cases);
  }
  EXPECT_GT(cases.inside, 30);
  EXPECT_GT(cases.outside, 30);
}

TEST(Blockage, DoesNotDependOnTheLengthOfTheDirection) {
  const MeshPair mesh = test::figure_4b();
  const Blockage near = blockage_of(mesh, 0, 1e-3 * kEast).value();
  EXPECT_NEAR((near.v_alpha - blockage_of(mesh, 0, 1e3 * kEast).value().v_alpha).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace foldless
