// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_pair.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

double area_sum(const MeshPair& mesh, const Points& points) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(points, t);
  return sum;
}

std::set<std::set<int>> triangle_sets(const MeshPair& mesh) {
  std::set<std::set<int>> sets;
  for (const auto& t : mesh.triangles().colwise()) sets.insert({t[0], t[1], t[2]});
  return sets;
}

TEST(MeshPair, KeepsTheTrianglesItWasMadeFrom) {
  const auto f = test::square_grid(4);
  const MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(mesh.triangles(), f.triangles);
  EXPECT_EQ(mesh.rest(), f.rest);
  EXPECT_EQ(mesh.deformed(), f.rest);
  EXPECT_EQ(mesh.edge_count(), 3 * 9 + 6);
}

TEST(MeshPair, DiamondHasBothTrianglesCounterClockwise) {
  const auto f = test::unit_square();
  const MeshPair mesh(f.triangles, f.rest);
  const int e = mesh.find_edge(0, 2).value();
  const Diamond d = mesh.diamond(e);
  EXPECT_GT(signed_area(mesh.rest().col(d.a), mesh.rest().col(d.b), mesh.rest().col(d.c)), 0);
  EXPECT_GT(signed_area(mesh.rest().col(d.b), mesh.rest().col(d.a), mesh.rest().col(d.d)), 0);
}

TEST(MeshPair, FlipSwapsTheDiagonalAndChangesTheRevision) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  const auto before = mesh.revision();
  const int e = mesh.find_edge(0, 2).value();
  ASSERT_TRUE(mesh.is_flip_legal(e));
  mesh.flip(e);
  EXPECT_EQ(mesh.edge(e), (Edge{1, 3}));
  EXPECT_NE(mesh.revision(), before);
  EXPECT_EQ(triangle_sets(mesh), (std::set<std::set<int>>{{0, 1, 3}, {1, 2, 3}}));
  for (const auto& t : mesh.triangles().colwise()) EXPECT_GT(signed_area(mesh.rest(), t), 0);
}

TEST(MeshPair, MovingAVertexChangesTheRevisionForWhatIsAtRestIsNotWhereItWas) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  const auto before = mesh.revision();
  mesh.move_vertex(2, Vec2(1, 1.5), Vec2(2, 3));
  EXPECT_NE(mesh.revision(), before);
  EXPECT_EQ(mesh.rest().col(2), Vec2(1, 1.5));
  EXPECT_EQ(mesh.deformed().col(2), Vec2(2, 3));
  EXPECT_EQ(mesh.rest().col(1), f.rest.col(1));
  EXPECT_EQ(mesh.deformed().col(1), f.rest.col(1));
}

TEST(MeshPair, BoundaryEdgesAndDuplicateEdgesAreNotFlippable) {
  const auto f = test::unit_square();
  const MeshPair mesh(f.triangles, f.rest);
  EXPECT_FALSE(mesh.is_flip_legal(mesh.find_edge(0, 1).value()));
  EXPECT_FALSE(mesh.find_edge(1, 3).has_value());
}

TEST(MeshPair, ACopyIsIndependent) {
  const auto f = test::unit_square();
  const MeshPair original(f.triangles, f.rest);
  MeshPair copy = original;
  copy.flip(copy.find_edge(0, 2).value());
  EXPECT_TRUE(original.find_edge(0, 2).has_value());
  EXPECT_EQ(original.triangles(), f.triangles);
}

TEST(MeshPair, ACopySharesEveryArrayUntilOneOfTheTwoChangesIt) {
  const auto f = test::unit_square();
  const MeshPair original(f.triangles, f.rest);
  const auto shared = [&](const MeshPair& copy) {
    return std::array{copy.triangles().data() == original.triangles().data(),
                      copy.rest().data() == original.rest().data(),
                      copy.deformed().data() == original.deformed().data()};
  };
  const auto shared_after = [&](const auto& change) {
    MeshPair copy = original;
    EXPECT_EQ(shared(copy), (std::array{true, true, true}));
    change(copy);
    EXPECT_EQ(original.triangles(), f.triangles);
    EXPECT_EQ(original.rest(), f.rest);
    EXPECT_EQ(original.deformed(), f.rest);
    return shared(copy);
  };
  const Points twice = 2 * f.rest;
  EXPECT_EQ(shared_after([&](MeshPair& copy) { copy.set_deformed(twice); }),
            (std::array{true, true, false}));
  EXPECT_EQ(shared_after([&](MeshPair& copy) {
              EXPECT_EQ(copy.exchange_deformed(twice), f.rest);
              EXPECT_EQ(copy.deformed(), twice);
            }),
            (std::array{true, true, false}));
  EXPECT_EQ(shared_after([&](MeshPair& copy) { copy.set_positions(twice, twice); }),
            (std::array{true, false, false}));
  EXPECT_EQ(shared_after([&](MeshPair& copy) {
              copy.move_vertex(1, {2, 0}, {3, 0});
            }),
            (std::array{true, false, false}));
  EXPECT_EQ(shared_after([](MeshPair& copy) { copy.flip(copy.find_edge(0, 2).value()); }),
            (std::array{false, true, true}));
  EXPECT_EQ(
      shared_after([](MeshPair& copy) { copy.split_edge(copy.find_edge(0, 2).value(), 0.5); }),
      (std::array{false, false, false}));
}

TEST(MeshPair, SplittingAnEdgeKeepsTheMapAndAppendsTheVertex) {
  for (const Edge edge : {Edge{0, 2}, Edge{0, 1}}) {
    const auto f = test::unit_square();
    Points deformed = f.rest;
    deformed.row(0) *= 3;
    MeshPair mesh(f.triangles, f.rest, deformed);
    const int v = mesh.split_edge(mesh.find_edge(edge[0], edge[1]).value(), 0.25);
    EXPECT_EQ(v, 4);
    EXPECT_EQ(mesh.face_count(), edge[1] == 2 ? 4 : 3);
    const Vec2 expected = 0.75 * f.rest.col(edge[0]) + 0.25 * f.rest.col(edge[1]);
    EXPECT_TRUE(mesh.rest().col(v).isApprox(expected));
    EXPECT_DOUBLE_EQ(mesh.deformed()(0, v), 3 * mesh.rest()(0, v));
    EXPECT_DOUBLE_EQ(area_sum(mesh, mesh.rest()), 1);
    EXPECT_DOUBLE_EQ(area_sum(mesh, mesh.deformed()), 3);
    for (const auto& t : mesh.triangles().colwise()) EXPECT_GT(signed_area(mesh.rest(), t), 0);
  }
}

TEST(MeshPair, SplittingATriangleKeepsTheMap) {
  const auto f = test::unit_square();
  MeshPair mesh(f.triangles, f.rest);
  const int v = mesh.split_triangle(1, {0.5, 0.25, 0.25});
  EXPECT_EQ(mesh.face_count(), 4);
  EXPECT_DOUBLE_EQ(area_sum(mesh, mesh.rest()), 1);
  EXPECT_EQ(mesh.triangles_of_vertex(v).size(), 3u);
}

TEST(MeshPair, WalksRoundInteriorAndBoundaryVertices) {
  const auto f = test::square_grid(3);
  const MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(mesh.triangles_of_vertex(4).size(), 6u);
  EXPECT_EQ(mesh.triangles_of_vertex(0).size(), 2u);
  EXPECT_EQ(mesh.triangles_of_vertex(2).size(), 1u);
  EXPECT_TRUE(mesh.is_boundary_vertex(0));
  EXPECT_FALSE(mesh.is_boundary_vertex(4));
}

TEST(MeshPair, KeepsVerticesThatNoTriangleUses) {
  auto f = test::unit_square();
  f.rest.conservativeResize(Eigen::NoChange, 5);
  f.rest.col(4) = Vec2(9, 9);
  const MeshPair mesh(f.triangles, f.rest);
  EXPECT_EQ(mesh.vertex_count(), 5);
  EXPECT_TRUE(mesh.is_isolated(4));
  EXPECT_TRUE(mesh.triangles_of_vertex(4).empty());
}

}  // namespace
}  // namespace foldless
