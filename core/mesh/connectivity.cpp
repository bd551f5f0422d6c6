// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/connectivity.h"

#include <array>
#include <cstddef>
#include <vector>

#include "core/large_pages.h"

namespace foldless {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::TriConnectivity;
using OpenMesh::VertexHandle;

/// Half-edges 2e and 2e + 1 are the two of edge e. Edges are numbered as triangles meet them.
class NumberedHalfedges {
 public:
  NumberedHalfedges(int vertices, std::size_t most) : last_of_(as_index(vertices), -1) {
    edges_.reserve(most);
  }

  /// The one from a to b, of an edge that a triangle brought along before or a new one.
  int from_to(int a, int b) {
    for (int e = last_of_[as_index(b)]; e >= 0; e = edges_[as_index(e)].before)
      if (edges_[as_index(e)].to == a) return 2 * e + 1;
    const int e = count();
    edges_.push_back({b, last_of_[as_index(a)]});
    last_of_[as_index(a)] = e;
    return 2 * e;
  }
  /// Of the edges.
  int count() const { return static_cast<int>(edges_.size()); }

 private:
  static std::size_t as_index(int i) { return static_cast<std::size_t>(i); }

  struct Edge {
    int to;
    int before;  ///< the edge that began at the same vertex before it, or −1
  };
  std::vector<int> last_of_;  ///< the last edge that began at a vertex, or −1
  std::vector<Edge> edges_;
};

/// The half-edges of a triangle, that of corner i from there to the next.
using HalfedgesOfTriangle = std::array<int, 3>;

/// Vertices, edges and faces, with nothing linked.
void make_unlinked(TriConnectivity& mesh, int vertices, int edges, Eigen::Index faces) {
  const auto edge_count = static_cast<std::size_t>(edges);
  const auto vertex_count = static_cast<std::size_t>(vertices);
  mesh.reserve(vertex_count, edge_count, static_cast<std::size_t>(faces));
  if (edges > 0) {  // what was reserved has a place that one can ask for once it has an edge
    auto& first = mesh.edge(mesh.edge_handle(mesh.new_edge(VertexHandle(0), VertexHandle(0))));
    ask_for_large_pages(&first, edge_count * sizeof(first));
  }
  mesh.resize(vertex_count, edge_count, static_cast<std::size_t>(faces));
}

/// As add_face() leaves them, the half-edge of a face ends at its first corner, and that of a
/// vertex inside is of the last of its triangles.
void link_triangle(TriConnectivity& mesh, Eigen::Index t, const Eigen::Vector3i& corners,
                   const HalfedgesOfTriangle& halfedges) {
  const FaceHandle face(static_cast<int>(t));
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeHandle h(halfedges[i]);
    const std::size_t next = (i + 1) % 3;
    mesh.set_vertex_handle(h, VertexHandle(corners[static_cast<Eigen::Index>(next)]));
    mesh.set_face_handle(h, face);
    mesh.set_next_halfedge_handle(h, HalfedgeHandle(halfedges[next]));
    mesh.set_halfedge_handle(VertexHandle(corners[static_cast<Eigen::Index>(i)]), h);
  }
  mesh.set_halfedge_handle(face, HalfedgeHandle(halfedges[2]));
}

/// Half-edges that no triangle has: that of a vertex at the boundary is the one that begins there.
void link_boundary(TriConnectivity& mesh) {
  std::vector<HalfedgeHandle> boundary;
  for (int h = 0; h < static_cast<int>(mesh.n_halfedges()); ++h) {
    const HalfedgeHandle outer(h), inner(h ^ 1);
    if (mesh.face_handle(outer).is_valid()) continue;
    const VertexHandle end = mesh.to_vertex_handle(mesh.prev_halfedge_handle(inner));
    mesh.set_vertex_handle(outer, end);
    mesh.set_halfedge_handle(mesh.to_vertex_handle(inner), outer);
    boundary.push_back(outer);
  }
  for (const HalfedgeHandle h : boundary)
    mesh.set_next_halfedge_handle(h, mesh.halfedge_handle(mesh.to_vertex_handle(h)));
}

}  // namespace

void connect(TriConnectivity& mesh, const Triangles& triangles, int vertex_count) {
  NumberedHalfedges numbered(vertex_count,
                             static_cast<std::size_t>(vertex_count + triangles.cols()) + 1);
  std::vector<HalfedgesOfTriangle> halfedges;
  halfedges.reserve(static_cast<std::size_t>(triangles.cols()));
  for (const auto& t : triangles.colwise()) {
    const int first = numbered.from_to(t[0], t[1]), second = numbered.from_to(t[1], t[2]);
    halfedges.push_back({first, second, numbered.from_to(t[2], t[0])});
  }
  make_unlinked(mesh, vertex_count, numbered.count(), triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    link_triangle(mesh, t, triangles.col(t), halfedges[static_cast<std::size_t>(t)]);
  link_boundary(mesh);
}

}  // namespace foldless
