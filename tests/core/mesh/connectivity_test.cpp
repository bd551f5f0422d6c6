// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "core/mesh/generate.h"

namespace foldless {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::TriConnectivity;
using OpenMesh::VertexHandle;

TriConnectivity face_by_face(const Triangles& triangles, int vertices) {
  TriConnectivity mesh;
  for (int v = 0; v < vertices; ++v) mesh.add_vertex();
  for (const auto& t : triangles.colwise())
    mesh.add_face(VertexHandle(t[0]), VertexHandle(t[1]), VertexHandle(t[2]));
  return mesh;
}

/// Every handle that the mesh keeps.
std::vector<int> handles_of(const TriConnectivity& mesh) {
  std::vector<int> handles;
  for (unsigned v = 0; v < mesh.n_vertices(); ++v)
    handles.push_back(mesh.halfedge_handle(VertexHandle(static_cast<int>(v))).idx());
  for (unsigned f = 0; f < mesh.n_faces(); ++f)
    handles.push_back(mesh.halfedge_handle(FaceHandle(static_cast<int>(f))).idx());
  for (unsigned i = 0; i < mesh.n_halfedges(); ++i) {
    const HalfedgeHandle h(static_cast<int>(i));
    for (const int handle :
         {mesh.to_vertex_handle(h).idx(), mesh.face_handle(h).idx(),
          mesh.next_halfedge_handle(h).idx(), mesh.prev_halfedge_handle(h).idx()})
      handles.push_back(handle);
  }
  return handles;
}

void expect_as_face_by_face(const Triangles& triangles, int vertices) {
  const TriConnectivity expected = face_by_face(triangles, vertices);
  TriConnectivity mesh;
  connect(mesh, triangles, vertices);
  ASSERT_EQ(mesh.n_vertices(), expected.n_vertices());
  ASSERT_EQ(mesh.n_edges(), expected.n_edges());
  ASSERT_EQ(mesh.n_faces(), expected.n_faces());
  EXPECT_EQ(handles_of(mesh), handles_of(expected));
}

/// The triangles in another order, each from another corner on, with other numbers of vertices.
Triangles shuffled(Triangles triangles, int vertices, std::mt19937& random) {
  std::vector<int> number(static_cast<std::size_t>(vertices));
  std::iota(number.begin(), number.end(), 0);
  std::ranges::shuffle(number, random);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(triangles.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, random);
  triangles = Triangles(triangles(Eigen::all, order));
  for (auto t : triangles.colwise()) {
    std::rotate(t.begin(), t.begin() + static_cast<int>(random() % 3), t.end());
    for (int& v : t) v = number[static_cast<std::size_t>(v)];
  }
  return triangles;
}

TEST(Connectivity, IsWhatAddingFaceByFaceMakes) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto size = [&random] { return 1 + static_cast<int>(random() % 9); };
    for (const Shape& shape : {grid({.columns = size(), .rows = size()}), disk({}),
                               annulus({.sectors = 3 + size(), .layers = size()})}) {
      const auto vertices = static_cast<int>(shape.rest.cols());
      expect_as_face_by_face(shape.triangles, vertices);
      expect_as_face_by_face(shuffled(shape.triangles, vertices, random), vertices);
    }
  }
}

TEST(Connectivity, HasPartsAndVerticesThatNoTriangleUses) {
  const Shape one = grid({.columns = 3, .rows = 2});
  const auto vertices = static_cast<int>(one.rest.cols());
  Triangles two(3, 2 * one.triangles.cols());
  two << one.triangles, (one.triangles.array() + vertices + 5).matrix();
  std::mt19937 random(1);
  expect_as_face_by_face(two, 2 * vertices + 7);
  expect_as_face_by_face(shuffled(two, 2 * vertices + 7, random), 2 * vertices + 7);
  expect_as_face_by_face(Triangles(3, 0), 4);
}

}  // namespace
}  // namespace foldless
