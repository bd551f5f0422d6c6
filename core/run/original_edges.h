// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The edges of a mesh before it was remeshed, to tell flipped edges from. An edge of a vertex
/// that a split made is the work of splits and never counts as flipped.
class OriginalEdges {
 public:
  /// Precondition: indices of `triangles` in [0, vertices).
  OriginalEdges(const Triangles& triangles, int vertices);

  bool contains(const Edge& edge) const;
  /// Edges of `triangles` between original vertices that the original mesh lacks, sorted.
  std::vector<Edge> flipped_in(const Triangles& triangles) const;

 private:
  std::vector<int> first_;   ///< vertex a → its entries in larger_, one past the last for #V
  std::vector<int> larger_;  ///< the other ends b > a of the edges of each vertex a
};

}  // namespace foldless
