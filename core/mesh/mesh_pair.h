// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/copy_on_write.h"
#include "core/mesh/stiffness.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// The two triangles beside an interior edge, the paper's diamond (4.3, inset): `ab` is the edge,
/// triangles (a, b, c) and (b, a, d) are counter-clockwise. Flipped: (c, d, b) and (d, c, a).
struct Diamond {
  int a, b, c, d;   ///< vertex indices
  int left, right;  ///< triangle indices of (a, b, c) and (b, a, d)
};

/// Rest mesh M and deformed mesh M′: one connectivity, two arrays of positions, so that they
/// cannot drift apart. Vertices are dense indices; original vertices keep theirs for ever and
/// vertices made by splits follow. Vertices that no triangle uses are kept. The units and the
/// frame of the positions are the caller's. A copy shares what it has, the connectivity and each
/// array by itself, until one of the two changes it.
class MeshPair {
 public:
  MeshPair() = default;
  /// M′ = M. Precondition: oriented manifold triangles with indices in range (see validate.h).
  MeshPair(const Triangles& triangles, const Points& rest);
  /// As above with its own deformed positions, 2 × #V.
  MeshPair(const Triangles& triangles, Points rest, Points deformed);

  int vertex_count() const { return static_cast<int>(rest_->cols()); }
  int face_count() const { return static_cast<int>(triangles_->cols()); }
  /// Edges are dense indices too, for interior and boundary edges alike.
  int edge_count() const { return static_cast<int>(connectivity_->n_edges()); }

  const Triangles& triangles() const { return *triangles_; }
  const Points& rest() const { return *rest_; }
  const Points& deformed() const { return *deformed_; }
  /// Replaces the positions of M′, 2 × #V.
  void set_deformed(Points deformed);
  /// The same; returns those that it had.
  Points exchange_deformed(Points deformed);
  /// The same pair in another frame: replaces both arrays, 2 × #V; connectivity and revision stay.
  void set_positions(Points rest, Points deformed);
  /// Moves one vertex in both meshes.
  void move_vertex(int v, const Vec2& rest, const Vec2& deformed);

  /// Of the plane of M, in the units of rest(); null: 1 everywhere.
  const std::shared_ptr<const Stiffness>& stiffness() const { return stiffness_; }
  void set_stiffness(std::shared_ptr<const Stiffness> stiffness);

  /// Changes with every flip, split and moved vertex, unique in the process: equal numbers mean
  /// equal triangles, and vertices that are at rest where they were.
  std::uint64_t revision() const { return revision_; }

  /// Vertex indices of an edge, the smaller first.
  Edge edge(int e) const;
  /// The edge between two vertices, or nothing.
  std::optional<int> find_edge(int a, int b) const;
  /// The edges of a triangle.
  std::array<int, 3> edges_of_triangle(int t) const;
  bool is_boundary_edge(int e) const;
  bool is_boundary_vertex(int v) const;
  /// True when no triangle uses the vertex.
  bool is_isolated(int v) const;
  /// The diamond of an interior edge. Precondition: not a boundary edge.
  Diamond diamond(int e) const;
  /// The triangles beside an edge: two, or one at the boundary.
  std::vector<int> triangles_of_edge(int e) const;
  /// The triangles round a vertex, in order round it; from one boundary edge to the other at a
  /// boundary.
  std::vector<int> triangles_of_vertex(int v) const;

  /// True when flipping makes no duplicate edge. Geometry is the caller's to check in both meshes.
  bool is_flip_legal(int e) const;
  /// Flips an interior edge; edge and triangle indices stay. Precondition: is_flip_legal(e).
  void flip(int e);
  /// Splits an edge at the same parameter in both meshes, 0 < t < 1 from edge(e)[0] to edge(e)[1];
  /// the map does not change. Returns the index of the new vertex.
  int split_edge(int e, double t);
  /// Splits a triangle in three at barycentric coordinates (> 0, sum 1), the same in both meshes.
  /// Returns the index of the new vertex.
  int split_triangle(int t, const Eigen::Vector3d& barycentric);

 private:
  void read_triangle(OpenMesh::FaceHandle f);
  void read_triangles_round(int v);
  void append_vertex(const Vec2& rest, const Vec2& deformed);
  void touch();

  CopyOnWrite<OpenMesh::TriConnectivity> connectivity_;
  CopyOnWrite<Triangles> triangles_;  ///< copy of the connectivity in the order solvers read it
  CopyOnWrite<Points> rest_;
  CopyOnWrite<Points> deformed_;
  std::shared_ptr<const Stiffness> stiffness_;
  std::uint64_t revision_ = 0;
};

}  // namespace foldless
