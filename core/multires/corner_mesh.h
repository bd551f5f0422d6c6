// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The connectivity of triangles while vertices are collapsed: flat arrays of half-edges, of which
/// triangle t has 3 t, 3 t + 1 and 3 t + 2, each from a corner to the next. Triangles keep their
/// numbers and their corners' places.
class CornerMesh {
 public:
  /// Precondition: oriented manifold triangles with indices below `vertices`; see validate.h.
  CornerMesh(const Triangles& triangles, int vertices);

  int vertex_count() const { return static_cast<int>(outgoing_.size()); }
  int face_count() const { return static_cast<int>(from_.size() / 3); }

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  int from(int h) const { return from_[static_cast<std::size_t>(h)]; }
  int to(int h) const { return from(next(h)); }
  /// A half-edge from an interior vertex that has not gone.
  int outgoing(int v) const { return outgoing_[static_cast<std::size_t>(v)]; }
  /// The next half-edge clockwise from the same interior vertex.
  int clockwise(int h) const { return next(opposite(h)); }

  bool is_gone(int v) const { return outgoing(v) == kGone; }
  bool is_face_gone(int t) const { return from(3 * t) == kGone; }

  /// Whether the map of the triangles stays one of a surface when the interior vertex from(h) goes
  /// to to(h): the two have no neighbours in common but those opposite their edge.
  bool may_collapse(int h);
  /// Takes the interior vertex from(h) to to(h), and with it the two triangles of their edge.
  /// Precondition: may_collapse(h).
  void collapse(int h);

 private:
  static constexpr int kGone = -2;
  static constexpr int kNone = -1;  ///< beyond the boundary

  int opposite(int h) const { return opposite_[static_cast<std::size_t>(h)]; }
  void join(int a, int b);
  void leave(int v, int h);
  /// Marks the neighbours of to(h) round it with a number that is new.
  void mark_neighbours_of_end(int h);
  void mark(int v) { marked_[static_cast<std::size_t>(v)] = mark_; }

  std::vector<int> from_;      ///< of every half-edge
  std::vector<int> opposite_;  ///< of every half-edge
  std::vector<int> outgoing_;  ///< of every vertex
  std::vector<int> marked_;    ///< of every vertex
  int mark_ = 0;
};

}  // namespace foldless
