// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/half_edges.h"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "core/mesh/generate.h"

namespace foldless {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// A square of 8 × 8 cells with a hole of 2 × 3, whose triangles are in no order, nor begin at any
/// corner.
Triangles shuffled_ring(std::mt19937& random) {
  const Triangles all = grid({.columns = 8, .rows = 8}).triangles;
  std::vector<int> order;
  for (int t = 0; t < all.cols(); ++t) {
    const int column = t / 2 % 8, row = t / 16;
    if (column < 3 || column > 4 || row < 3 || row > 5) order.push_back(t);
  }
  std::ranges::shuffle(order, random);
  Triangles triangles = all(Eigen::all, order);
  for (auto t : triangles.colwise())
    std::rotate(t.begin(), t.begin() + static_cast<int>(random() % 3), t.end());
  return triangles;
}

/// The same by OpenMesh.
OpenMesh::TriConnectivity judge_of(const Triangles& triangles, int vertices) {
  OpenMesh::TriConnectivity judge;
  for (int v = 0; v < vertices; ++v) judge.add_vertex();
  for (const auto& t : triangles.colwise())
    judge.add_face(VertexHandle(t[0]), VertexHandle(t[1]), VertexHandle(t[2]));
  return judge;
}

using HalfEdge = std::array<int, 4>;
HalfEdge half_edge(const HalfEdges& mesh, int h) {
  return {mesh.to(h), mesh.next(h), mesh.previous(h), mesh.triangle(h)};
}
HalfEdge half_edge(const OpenMesh::TriConnectivity& mesh, int index) {
  const HalfedgeHandle h(index);
  return {mesh.to_vertex_handle(h).idx(), mesh.next_halfedge_handle(h).idx(),
          mesh.prev_halfedge_handle(h).idx(), mesh.face_handle(h).idx()};
}

void expect_same(const HalfEdges& mesh, const OpenMesh::TriConnectivity& judge) {
  ASSERT_EQ(mesh.edge_count(), judge.n_edges());
  ASSERT_EQ(mesh.triangle_count(), judge.n_faces());
  ASSERT_EQ(mesh.vertex_count(), judge.n_vertices());
  for (int h = 0; h < 2 * mesh.edge_count(); ++h)
    ASSERT_EQ(half_edge(mesh, h), half_edge(judge, h)) << "half-edge " << h;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    ASSERT_EQ(mesh.first(t), judge.halfedge_handle(FaceHandle(t)).idx()) << "triangle " << t;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    ASSERT_EQ(mesh.outgoing(v), judge.halfedge_handle(VertexHandle(v)).idx()) << "vertex " << v;
}

TEST(HalfEdges, AreThoseOfOpenMeshAfterAnyFlipsAndSplits) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Triangles triangles = shuffled_ring(random);
    const int vertices = 82;  // those of the hole's inside and the last have no triangle
    HalfEdges mesh(triangles, vertices);
    OpenMesh::TriConnectivity judge = judge_of(triangles, vertices);
    ASSERT_NO_FATAL_FAILURE(expect_same(mesh, judge));
    const auto any = [&](int count) {
      return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    int flipped = 0;
    for (int change = 0; change < 400; ++change) {
      const int e = any(mesh.edge_count());
      ASSERT_EQ(mesh.may_flip(e), judge.is_flip_ok(EdgeHandle(e)));
      if (change % 4 != 0) {
        if (!mesh.may_flip(e)) continue;
        mesh.flip(e);
        judge.flip(EdgeHandle(e));
        ++flipped;
        continue;
      }
      const int v = mesh.vertex_count();
      mesh.add_vertex();
      judge.add_vertex();
      if (change % 8 == 0) {
        mesh.split_edge(e, v);
        judge.split(EdgeHandle(e), VertexHandle(v));
      } else {
        const int t = any(mesh.triangle_count());
        mesh.split_triangle(t, v);
        judge.split(FaceHandle(t), VertexHandle(v));
      }
      ASSERT_NO_FATAL_FAILURE(expect_same(mesh, judge)) << "after change " << change;
    }
    EXPECT_GT(flipped, 100);
    for (int a = 0; a < vertices; ++a)
      for (int b = 0; b < vertices; ++b)
        ASSERT_EQ(mesh.find(a, b), judge.find_halfedge(VertexHandle(a), VertexHandle(b)).idx());
  }
}

TEST(HalfEdges, ThereAreNoneWithoutTriangles) {
  const HalfEdges mesh(Triangles(3, 0), 2);
  EXPECT_EQ(mesh.edge_count(), 0);
  EXPECT_EQ(mesh.outgoing(1), HalfEdges::kNone);
  EXPECT_EQ(mesh.find(0, 1), HalfEdges::kNone);
}

}  // namespace
}  // namespace foldless
