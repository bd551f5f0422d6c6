// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/engraved.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/mesh/boundary.h"
#include "core/mesh/generate.h"
#include "tests/support/mesh_measures.h"
#include "tests/support/sanitizers.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using Loop = std::vector<OutlineCorner>;

/// The square from (0, 0) to (1, 1) under a map that is linear on every triangle, and bent.
MeshPair bent_square() {
  const Shape shape = grid({.columns = 8, .rows = 8, .width = 1, .height = 1});
  Points deformed = shape.rest;
  for (auto p : deformed.colwise())
    p += 0.03 * Vec2(std::sin(6 * p.y()), std::cos(5 * p.x() + p.y()));
  return {shape.triangles, shape.rest, deformed};
}

Vec2 on_circle(const Vec2& middle, double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return middle + radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Counter-clockwise about a middle.
Loop random_star(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto fraction = [&] { return static_cast<double>(random() % 1000) / 1000; };
  const int corners = 3 + static_cast<int>(random() % 20);
  Loop star;
  for (int i = 0; i < corners; ++i)
    star.push_back(
        {on_circle({0.5, 0.5}, 0.1 + 0.38 * fraction(), (i + 0.8 * fraction()) / corners)});
  return star;
}

double area_of(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    area += 0.5 * cross(loop[i].rest, loop[(i + 1) % loop.size()].rest);
  return area;
}

/// Where the map of `mesh` takes a point.
Vec2 image_of(const MeshPair& mesh, const Vec2& p) {
  Vec2 image = Vec2::Zero();
  double deepest = -1;
  for (const auto& t : mesh.triangles().colwise()) {
    const Eigen::Vector3d place = barycentric_of(mesh.rest(), t, p);
    if (place.minCoeff() <= deepest) continue;
    deepest = place.minCoeff();
    image = mesh.deformed()(Eigen::all, Eigen::Vector3i(t)) * place;
  }
  return image;
}

double off_the_sides(const Vec2& p, const Loop& loop) {
  double least = 1;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i].rest, b = loop[(i + 1) % loop.size()].rest;
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - t * (b - a)).norm());
  }
  return least;
}

/// The part of `whole` within loops, of which the first is the outer one.
void expect_part(const MeshPair& part, const MeshPair& whole, const std::vector<Loop>& loops) {
  EXPECT_TRUE(test::is_valid(part));
  double area = 0;
  Eigen::Index corner = 0;
  for (const Loop& loop : loops) {
    area += area_of(loop);
    for (const OutlineCorner& c : loop) EXPECT_EQ(Vec2(part.rest().col(corner++)), c.rest);
  }
  EXPECT_NEAR(test::area_of({part.triangles(), part.rest()}), area, 1e-6);
  for (int v = 0; v < part.vertex_count(); ++v) {
    const Vec2 p = part.rest().col(v);
    EXPECT_LT((image_of(whole, p) - part.deformed().col(v)).norm(), 1e-6) << v;
    EXPECT_FALSE(part.is_isolated(v)) << v;
    double off = 1;
    for (const Loop& loop : loops) off = std::min(off, off_the_sides(p, loop));
    EXPECT_TRUE(off < 1e-6 || !part.is_boundary_vertex(v)) << v;
  }
}

TEST(Engraved, IsThePartOnTheLeftOfAPolygonUnderTheSameMap) {
  const MeshPair whole = bent_square();
  for (std::uint64_t seed = 1; seed <= test::seeds(200); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<Loop> loops{random_star(seed)};
    const auto part = engraved(whole, loops);
    ASSERT_TRUE(part);
    expect_part(*part, whole, loops);
  }
}

TEST(Engraved, SidesMayRunAlongEdgesAndThroughVerticesAndHaveCornersThere) {
  const MeshPair whole = bent_square();
  const Loop along_edges{{{0.25, 0.25}}, {{0.75, 0.25}}, {{0.75, 0.625}}, {{0.25, 0.625}}};
  const Loop through_vertices{{{0.25, 0.25}}, {{0.5, 0.3125}}, {{0.75, 0.5}}, {{0.25, 0.75}}};
  const Loop at_vertices{{whole.rest().col(10), 10}, {{0.8, 0.3}}, {whole.rest().col(60), 60}};
  for (const Loop& loop : {along_edges, through_vertices, at_vertices}) {
    const auto part = engraved(whole, {loop});
    ASSERT_TRUE(part);
    expect_part(*part, whole, {loop});
  }
}

TEST(Engraved, LeavesHolesOut) {
  const MeshPair whole = bent_square();
  Loop outer, hole;
  for (int i = 0; i < 12; ++i) {
    outer.push_back({on_circle({0.5, 0.5}, 0.45, i / 12.0)});
    hole.push_back({on_circle({0.52, 0.47}, 0.2, -i / 12.0)});
  }
  const auto part = engraved(whole, {outer, hole});
  ASSERT_TRUE(part);
  expect_part(*part, whole, {outer, hole});
}

TEST(Engraved, IsNothingWherePolygonsCrossOrTouch) {
  const MeshPair whole = bent_square();
  const Loop eight{{{0.2, 0.2}}, {{0.8, 0.7}}, {{0.8, 0.2}}, {{0.2, 0.7}}};
  const Loop twice{{{0.2, 0.2}}, {{0.8, 0.2}}, {{0.5, 0.5}},
                   {{0.8, 0.8}}, {{0.2, 0.8}}, {{0.5, 0.5}}};
  const Loop touching{{{0.2, 0.2}}, {{0.8, 0.2}}, {{0.8, 0.8}}, {{0.5, 0.2}}, {{0.2, 0.8}}};
  for (const Loop& loop : {eight, twice, touching}) EXPECT_FALSE(engraved(whole, {loop}));
  const Loop square{{{0.2, 0.2}}, {{0.6, 0.2}}, {{0.6, 0.6}}, {{0.2, 0.6}}},
      other{{{0.4, 0.4}}, {{0.9, 0.4}}, {{0.9, 0.9}}, {{0.4, 0.9}}};
  EXPECT_TRUE(engraved(whole, {square}));
  EXPECT_FALSE(engraved(whole, {square, other}));
}

TEST(Engraved, IsNothingWhereThePartWouldBeOnBothSides) {
  const Loop square{{{0.2, 0.2}}, {{0.8, 0.2}}, {{0.8, 0.8}}, {{0.2, 0.8}}},
      within{{{0.4, 0.4}}, {{0.6, 0.4}}, {{0.6, 0.6}}, {{0.4, 0.6}}};
  EXPECT_FALSE(engraved(bent_square(), {square, within}));
}

}  // namespace
}  // namespace foldless
