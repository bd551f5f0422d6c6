// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/collapse_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "tests/support/meshes.h"
#include "tests/support/random_scene.h"
#include "tests/support/random_vector.h"

namespace foldless {
namespace {

constexpr double kEighth = std::numbers::pi / 4;  // of a turn [rad]
constexpr double kAnything = std::numeric_limits<double>::infinity();

/// Every collapse that the guards of the geometry allow.
CollapseSettings from(int first_removable, double largest_rise = kAnything,
                      double largest_distortion = kAnything) {
  CollapseSettings settings;
  settings.energy.density = find_density("arap");
  settings.energy.beta = 1;
  settings.energy.barrier_area_weighted = true;
  settings.first_removable = first_removable;
  settings.largest_rise = largest_rise;
  settings.largest_distortion = largest_distortion;
  return settings;
}

/// The last vertex inside a closed link of the others, which are counter-clockwise.
MeshPair fan(const std::vector<Vec2>& link, const Vec2& middle) {
  const int n = static_cast<int>(link.size());
  Points points(2, n + 1);
  Triangles triangles(3, n);
  for (int k = 0; k < n; ++k) {
    points.col(k) = link[static_cast<std::size_t>(k)];
    triangles.col(k) << n, k, (k + 1) % n;
  }
  points.col(n) = middle;
  EXPECT_TRUE(is_injective(triangles, points));
  return {triangles, points};
}

MeshPair square_with_middle() { return fan({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0.5, 0.5}); }

double area(const MeshPair& mesh, const Points& points) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(points, t);
  return sum;
}

bool is_valid(const MeshPair& mesh) {
  return is_injective(mesh.triangles(), mesh.rest(), mesh.deformed());
}

TEST(CollapseEdges, TakesBackASplitInside) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  mesh.split_edge(mesh.find_edge(0, 2).value(), 0.3);
  ASSERT_EQ(collapse_edges(mesh, from(4, 0)), 1);
  EXPECT_EQ(mesh.vertex_count(), 4);
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.rest(), f.rest);
  EXPECT_TRUE(is_valid(mesh));
}

TEST(CollapseEdges, KeepsVerticesBelowTheFirstThatMayGo) {
  MeshPair mesh = square_with_middle();
  EXPECT_EQ(collapse_edges(mesh, from(5)), 0);
  EXPECT_EQ(mesh.vertex_count(), 5);
}

TEST(CollapseEdges, ASplitOfTheBoundaryGoesWhereItIsStraight) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  mesh.split_edge(mesh.find_edge(0, 1).value(), 1.0 / 3);
  EXPECT_EQ(collapse_edges(mesh, from(4)), 1);
  EXPECT_EQ(mesh.rest(), f.rest);
}

TEST(CollapseEdges, ABendOfTheRestBoundaryStays) {
  for (const double bend : {1e-9, -1e-9, 0.2, -0.2}) {
    SCOPED_TRACE(bend);
    const auto f = test::unit_square();
    MeshPair mesh(f.triangles, f.rest);
    mesh.split_edge(mesh.find_edge(0, 1).value(), 0.5);
    Points rest = mesh.rest();
    rest(1, 4) = bend;
    mesh.set_positions(rest, mesh.deformed());
    EXPECT_EQ(collapse_edges(mesh, from(4)), 0);
  }
}

TEST(CollapseEdges, ACornerOfTheBoundaryStays) {
  MeshPair mesh = square_with_middle();
  EXPECT_EQ(collapse_edges(mesh, from(0)), 1) << "only the middle";
  EXPECT_EQ(mesh.vertex_count(), 4);
}

// Only the vertex in the notch sees all of the link.
const std::vector<Vec2> kNotched{{0, 1.2}, {2, -1}, {2, 2}, {-2, 2}, {-2, -1}};

TEST(CollapseEdges, NewTrianglesArePositiveInTheRestMesh) {
  MeshPair mesh = fan(kNotched, {0, 1.6});
  ASSERT_EQ(collapse_edges(mesh, from(5)), 1);
  for (const auto& t : mesh.triangles().colwise()) EXPECT_TRUE((t.array() == 0).any());
  EXPECT_TRUE(is_valid(mesh));
}

TEST(CollapseEdges, NewTrianglesArePositiveInTheDeformedMesh) {
  const MeshPair notched = fan(kNotched, {0, 1.6});
  const MeshPair convex = fan({{0, -2}, {2, -1}, {2, 2}, {-2, 2}, {-2, -1}}, {0, 1});
  MeshPair mesh(convex.triangles(), convex.rest(), notched.rest());
  ASSERT_EQ(collapse_edges(mesh, from(5)), 1);
  for (const auto& t : mesh.triangles().colwise()) EXPECT_TRUE((t.array() == 0).any());
  EXPECT_TRUE(is_valid(mesh));
}

TEST(CollapseEdges, AVertexStaysWhereNoNeighbourSeesItsLinkInBothMeshes) {
  const MeshPair rest = fan(kNotched, {0, 1.6});
  std::vector<Vec2> next_notched = kNotched;
  std::rotate(next_notched.begin(), next_notched.end() - 1, next_notched.end());
  MeshPair mesh(rest.triangles(), rest.rest(), fan(next_notched, {0, 1.6}).rest());
  EXPECT_EQ(collapse_edges(mesh, from(5)), 0);
}

TEST(CollapseEdges, NewTrianglesKeepTheBoundOnTheirAreas) {
  // Any two triangles over the square have one of 1/50 of its rest area.
  const MeshPair rest = square_with_middle();
  const MeshPair flat = fan({{0, 0}, {1, 0}, {0.02, 0.02}, {0, 1}}, {0.01, 0.01});
  CollapseSettings settings = from(4);
  settings.energy.delta = 0.1;
  MeshPair mesh(rest.triangles(), rest.rest(), flat.rest());
  EXPECT_EQ(collapse_edges(mesh, settings), 0);
  settings.energy.delta = 1e-5;
  EXPECT_EQ(collapse_edges(mesh, settings), 1);
}

TEST(CollapseEdges, NewTrianglesAreNoNeedlesAtRest) {
  // The link of the middle is a flat triangle once the middle is gone.
  MeshPair mesh = fan({{0, 0}, {1, 0}, {0.5, 1e-7}}, {0.5, 5e-8});
  EXPECT_EQ(collapse_edges(mesh, from(3)), 0);
}

TEST(CollapseEdges, MakesNoEdgeTwice) {
  // Vertex 9 is inside the square 0, 2, 1, 3. Two strips, one round 0 and one round 1, lead to a
  // sheet below it where 0 and 1 have an edge: the diagonal that is left is 2–3.
  Points points(2, 10);
  points << -1, 1, 0, 0, -1.7, -1.7, 0, 1.7, 1.7, 0,  //
      0, 0, -1, 1, 0.7, -0.7, -2, -0.7, 0.7, 0;
  Triangles triangles(3, 11);
  triangles << 9, 9, 9, 9, 0, 0, 0, 0, 1, 1, 1,  //
      0, 2, 1, 3, 3, 4, 5, 6, 6, 7, 8,           //
      2, 1, 3, 0, 4, 5, 6, 1, 7, 8, 3;
  // Vertices 0 and 1 are at the boundary and more than a full turn: so it has to be.
  MeshPair mesh(triangles, points);
  ASSERT_TRUE(is_injective_inside(mesh.triangles(), points, points));
  ASSERT_EQ(collapse_edges(mesh, from(9)), 1);
  EXPECT_TRUE(mesh.find_edge(2, 3).has_value());
  EXPECT_TRUE(is_injective_inside(mesh.triangles(), mesh.rest(), mesh.deformed()));
}

// Round vertex 0 from its boundary neighbour 1 to 5, with a split of the edge 0–1 that is bent up:
// without it the edge goes straight to `end`, which may be beyond 5.
MeshPair bent_lip(const Vec2& end) {
  Points rest(2, 6);
  rest << 0, 2, 0.5, -1, -0.5, 1,  //
      0, 0.5, 1.5, 0.5, -1.5, -0.125;
  Triangles triangles(3, 4);
  triangles << 0, 0, 0, 0,  //
      1, 2, 3, 4,           //
      2, 3, 4, 5;
  MeshPair mesh(triangles, rest);
  const int bend = mesh.split_edge(mesh.find_edge(0, 1).value(), 0.25);
  Points u = mesh.rest();
  u.col(1) = end;
  u.col(bend) = Vec2(0.5, 0.15);
  mesh.set_deformed(u);
  EXPECT_TRUE(is_valid(mesh));
  return mesh;
}

TEST(CollapseEdges, AVertexOfTheBoundaryStaysWhereANeighbourWouldOverlapItself) {
  MeshPair open = bent_lip({2, 0.3}), crossed = bent_lip({2, -0.5}), closed = bent_lip({2, -0.25});
  EXPECT_EQ(collapse_edges(open, from(6)), 1);
  EXPECT_TRUE(is_valid(open));
  EXPECT_EQ(collapse_edges(crossed, from(6)), 0);
  EXPECT_EQ(collapse_edges(closed, from(6)), 0);
}

TEST(CollapseEdges, TheEnergyBoundsWhatGoes) {
  MeshPair mesh = square_with_middle();
  Points u = mesh.rest();
  u.col(4) += Vec2(0.3, 0.1);
  mesh.set_deformed(u);
  MeshPair same = mesh;
  EXPECT_EQ(collapse_edges(same, from(4, -10)), 0);
  EXPECT_EQ(collapse_edges(mesh, from(4, 0)), 1) << "without the middle the map is the identity";
}

TEST(CollapseEdges, TheDistortionBoundsWhatGoes) {
  // An octagon turns into a star: triangles of three corners suffer more than those to the middle.
  std::vector<Vec2> octagon, star;
  for (int k = 0; k < 8; ++k) {
    octagon.emplace_back(std::cos(k * kEighth), std::sin(k * kEighth));
    star.push_back(octagon.back() * (k % 2 ? 0.72 : 1));
  }
  const MeshPair rest = fan(octagon, {0, 0});
  MeshPair mesh(rest.triangles(), rest.rest(), fan(star, {0, 0}).rest());
  EXPECT_EQ(collapse_edges(mesh, from(8, kAnything, 2)), 0);
  EXPECT_EQ(collapse_edges(mesh, from(8, kAnything, 20)), 1);
}

/// A random mesh, shaken in both poses, with vertices on its edges that splits made.
MeshPair refined_mesh(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Shape shape = test::random_shape(random);
  MeshPair mesh(shape.triangles, shape.rest);
  for (int k = 0; k < 40; ++k)
    mesh.split_edge(static_cast<int>(random() % static_cast<unsigned>(mesh.edge_count())),
                    0.2 + 0.6 * unit(random));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Points rest = mesh.rest(), u = mesh.deformed();
    u.col(v) += 0.1 * (test::random_vector(unit, random) - Vec2(0.5, 0.5));
    if (!mesh.is_boundary_vertex(v)) rest.col(v) += 0.01 * test::random_vector(unit, random);
    if (is_injective(mesh.triangles(), rest, u)) mesh.set_positions(rest, u);
  }
  return mesh;
}

TEST(CollapseEdges, RandomMeshesStayValidWithTheirOutlineAndOriginalVertices) {
  int removed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    MeshPair mesh = refined_mesh(random);
    const MeshPair before = mesh;
    const int kept = before.vertex_count() - 40;
    const int count = collapse_edges(mesh, from(kept));
    removed += count;
    EXPECT_EQ(mesh.vertex_count(), before.vertex_count() - count);
    EXPECT_TRUE(is_valid(mesh));
    EXPECT_EQ(mesh.rest().leftCols(kept), before.rest().leftCols(kept));
    EXPECT_EQ(mesh.deformed().leftCols(kept), before.deformed().leftCols(kept));
    EXPECT_NEAR(area(mesh, mesh.rest()), area(before, before.rest()), 1e-12);
    EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(),
              before.vertex_count() - before.edge_count() + before.face_count());
  }
  EXPECT_GT(removed, 60 * 20) << "the claim would be empty";
}

}  // namespace
}  // namespace foldless
