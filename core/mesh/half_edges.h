// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The connectivity of oriented manifold triangles with a boundary, which flips and splits change.
/// Edge e has half-edges 2 e and 2 e + 1, one each way; those beyond the boundary go round it.
/// Numbers stay: what is new has the next. Numbers and orders are those that OpenMesh's
/// TriConnectivity would give. Indices are the caller's to keep in range.
class HalfEdges {
 public:
  static constexpr int kNone = -1;

  HalfEdges() = default;
  /// Precondition: oriented manifold triangles with indices below `vertices`; see validate.h.
  HalfEdges(const Triangles& triangles, int vertices);

  int vertex_count() const { return static_cast<int>(outgoing_.size()); }
  int edge_count() const { return static_cast<int>(half_edges_.size() / 2); }
  int triangle_count() const { return static_cast<int>(first_.size()); }

  static int opposite(int h) { return h ^ 1; }
  int next(int h) const { return at(h).next; }
  int previous(int h) const { return at(h).previous; }
  int to(int h) const { return at(h).to; }
  int from(int h) const { return to(opposite(h)); }
  /// kNone beyond the boundary.
  int triangle(int h) const { return at(h).triangle; }
  bool is_boundary(int h) const { return triangle(h) == kNone; }
  bool is_boundary_edge(int e) const { return is_boundary(2 * e) || is_boundary(2 * e + 1); }

  /// The half-edge with which a triangle begins.
  int first(int t) const { return first_[static_cast<std::size_t>(t)]; }
  /// A half-edge from the vertex; beyond the boundary where the vertex is at it, and kNone where
  /// no triangle uses it.
  int outgoing(int v) const { return outgoing_[static_cast<std::size_t>(v)]; }
  /// The half-edge from a to b, or kNone.
  int find(int a, int b) const;

  /// True when the edge is inside and the one across its two triangles is not there yet.
  bool may_flip(int e) const;
  /// Turns an edge within its two triangles. Precondition: may_flip(e).
  void flip(int e);
  /// Appends a vertex that no triangle uses.
  void add_vertex() { outgoing_.push_back(kNone); }
  /// Splits an edge, and the triangles beside it, at a vertex that no triangle uses.
  void split_edge(int e, int v);
  /// Splits a triangle in three at a vertex that no triangle uses.
  void split_triangle(int t, int v);

 private:
  struct HalfEdge {
    int to;
    int next;
    int previous;
    int triangle;
  };

  const HalfEdge& at(int h) const { return half_edges_[static_cast<std::size_t>(h)]; }
  HalfEdge& at(int h) { return half_edges_[static_cast<std::size_t>(h)]; }
  int& first_of(int t) { return first_[static_cast<std::size_t>(t)]; }
  int& outgoing_of(int v) { return outgoing_[static_cast<std::size_t>(v)]; }
  int clockwise(int h) const { return next(opposite(h)); }

  /// Returns the half-edge from → to of a new edge.
  int add_edge(int from, int to);
  int add_triangle();
  void link(int before, int after);
  /// Makes a triangle of three half-edges, and begins it with the first.
  void close(int t, int a, int b, int c);
  void link_boundary();  ///< of all half-edges, when all triangles are there

  std::vector<HalfEdge> half_edges_;
  std::vector<int> first_;     ///< of every triangle
  std::vector<int> outgoing_;  ///< of every vertex
};

}  // namespace foldless
