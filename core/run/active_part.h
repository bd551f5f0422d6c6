// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/method/method.h"

namespace foldless {

/// The part of a mesh that its handles can move: the components with a handle. What is idle, other
/// components and vertices that no triangle uses, stays where it is and has no say in the solving:
/// the part is solved as a mesh of its own and put back into the whole, in the order of its
/// vertices and triangles there. What a method adds to the part comes last in the whole; where it
/// removes more than it added, later vertices and triangles of the whole move up.
class ActivePart {
 public:
  ActivePart(const MeshPair& whole, const std::vector<Handle>& handles);

  bool is_empty() const { return faces_of_part_ == 0; }
  /// Nothing is idle: the part is the whole, whatever a method adds to it.
  bool is_whole() const { return is_whole_; }
  /// D: see active_diagonal().
  double diagonal() const { return diagonal_; }
  /// The problem on the part alone. Precondition: `problem` has the mesh and the handles that the
  /// part was made of.
  Problem of(const Problem& problem) const;

  /// The triangles of the whole with those of the part, 3 × #F of the part, as they are now.
  Triangles whole_triangles(const Triangles& part, int part_vertices) const;
  /// Rest and deformed positions of the whole with those of the part, 2 × #V of the part, as they
  /// are now.
  Points whole_rest(Points part) const { return whole_points(std::move(part), rest_); }
  Points whole_deformed(Points part) const { return whole_points(std::move(part), deformed_); }

 private:
  Points whole_points(Points part, const Points& then) const;

  std::vector<bool> is_active_vertex_;
  bool is_whole_;
  double diagonal_;
  int faces_of_part_ = 0;
  // Of the whole that the part was made of, where that is more than the part:
  std::vector<bool> is_active_face_;
  Triangles triangles_;
  Points rest_, deformed_;
};

/// D: the diagonal of the rest bounding box of the part that handles can move, the unit of every
/// tolerance; of all that triangles use where there is no handle. [length]
double active_diagonal(const Triangles& triangles, const Points& rest,
                       const std::vector<Handle>& handles);

}  // namespace foldless
