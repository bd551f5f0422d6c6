// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/corner_mesh.h"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <algorithm>
#include <random>
#include <utility>

#include "core/mesh/generate.h"

namespace foldless {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

/// A grid whose triangles are in no order, nor begin at any corner.
Triangles shuffled_grid(int cells, std::mt19937& random) {
  Triangles triangles = grid({.columns = cells, .rows = cells}).triangles;
  std::vector<int> order(static_cast<std::size_t>(triangles.cols()));
  for (std::size_t t = 0; t < order.size(); ++t) order[t] = static_cast<int>(t);
  std::ranges::shuffle(order, random);
  triangles = Triangles(triangles(Eigen::all, order));
  for (auto t : triangles.colwise())
    std::rotate(t.begin(), t.begin() + static_cast<int>(random() % 3), t.end());
  return triangles;
}

/// The same collapses by OpenMesh.
class Judge : public OpenMesh::TriConnectivity {
 public:
  Judge(const Triangles& triangles, int vertices) {
    request_vertex_status();
    request_edge_status();
    request_halfedge_status();
    request_face_status();
    for (int v = 0; v < vertices; ++v) add_vertex();
    for (const auto& t : triangles.colwise())
      add_face(VertexHandle(t[0]), VertexHandle(t[1]), VertexHandle(t[2]));
  }
  bool is_inside(int v) const {
    return !status(VertexHandle(v)).deleted() && !is_boundary(VertexHandle(v));
  }
  /// The neighbours clockwise, and whether the vertex may go to each.
  std::vector<std::pair<int, bool>> ways_of(int v) {
    std::vector<std::pair<int, bool>> ways;
    for (auto h = cvoh_iter(VertexHandle(v)); h.is_valid(); ++h)
      ways.emplace_back(to_vertex_handle(*h).idx(), is_collapse_ok(*h));
    return ways;
  }
  void collapse_to(int v, int end) { collapse(find_halfedge(VertexHandle(v), VertexHandle(end))); }
  /// Empty: it has gone.
  std::vector<int> face_of(int t) const {
    std::vector<int> corners;
    if (status(FaceHandle(t)).deleted()) return corners;
    for (auto v = cfv_iter(FaceHandle(t)); v.is_valid(); ++v) corners.push_back(v->idx());
    return corners;
  }
};

std::vector<std::pair<int, bool>> ways_of(CornerMesh& mesh, int v) {
  std::vector<std::pair<int, bool>> ways;
  int h = mesh.outgoing(v);
  do {
    ways.emplace_back(mesh.to(h), mesh.may_collapse(h));
    h = mesh.clockwise(h);
  } while (h != mesh.outgoing(v));
  return ways;
}

std::vector<int> face_of(const CornerMesh& mesh, int t) {
  if (mesh.is_face_gone(t)) return {};
  return {mesh.from(3 * t), mesh.from(3 * t + 1), mesh.from(3 * t + 2)};
}

void collapse_to(CornerMesh& mesh, int v, int end) {
  int h = mesh.outgoing(v);
  while (mesh.to(h) != end) h = mesh.clockwise(h);
  mesh.collapse(h);
}

/// One vertex inside after the other goes to any neighbour that it may go to.
void compare_collapses(int cells, std::mt19937& random) {
  const Triangles triangles = shuffled_grid(cells, random);
  const int vertices = (cells + 1) * (cells + 1);
  CornerMesh mesh(triangles, vertices);
  Judge judge(triangles, vertices);
  for (int round = 0; round < 3; ++round)
    for (int v = 0; v < vertices; ++v) {
      ASSERT_EQ(mesh.is_gone(v), judge.status(VertexHandle(v)).deleted()) << v;
      if (!judge.is_inside(v)) continue;
      auto ways = judge.ways_of(v);
      ASSERT_EQ(ways_of(mesh, v), ways) << v;
      std::erase_if(ways, [](const auto& way) { return !way.second; });
      if (ways.empty() || random() % 2 == 0) continue;
      const int end = ways[random() % ways.size()].first;
      judge.collapse_to(v, end);
      collapse_to(mesh, v, end);
    }
  for (int t = 0; t < mesh.face_count(); ++t) ASSERT_EQ(face_of(mesh, t), judge.face_of(t));
}

TEST(CornerMesh, CollapsesAsOpenMeshDoesAndMeetsNeighboursInItsOrder) {
  std::mt19937 random(7);
  for (const int cells : {2, 3, 4, 6, 9, 14}) {
    SCOPED_TRACE(cells);
    for (int i = 0; i < 12 && !testing::Test::HasFatalFailure(); ++i)
      compare_collapses(cells, random);
  }
}

TEST(CornerMesh, AVertexMayNotGoWhereANeighbourOfBothWouldBeTwice) {
  // A triangle with a vertex inside, and one more inside a third of it.
  Triangles triangles(3, 5);
  triangles << 0, 1, 2, 0, 3,  //
      1, 2, 0, 3, 2,           //
      3, 3, 4, 4, 4;
  CornerMesh mesh(triangles, 5);
  int h = mesh.outgoing(3);
  while (mesh.to(h) != 4) h = mesh.clockwise(h);
  EXPECT_TRUE(mesh.may_collapse(h));
  while (mesh.to(h) != 0) h = mesh.clockwise(h);
  EXPECT_FALSE(mesh.may_collapse(h)) << "2 is a neighbour of both, and not of their edge";
}

}  // namespace
}  // namespace foldless
