// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The inner edges of a triangulated disk as curves that its vertices take with them. The vertices
/// move, edges of the triangulation flip where they have to, and every curve is known by the edges
/// that it crosses: no more often than its homotopy class asks for, and no other curve at all.
/// Compare the integer coordinates of curves under flips [GSC21].
class CarriedCurves {
 public:
  struct Curve {
    int from, to;  ///< vertices
    Points bends;  ///< where it crosses edges, from the one to the other; they divide edges evenly
  };

  /// The curves are the edges as they are. `triangles`: counter-clockwise.
  CarriedCurves(const std::vector<Eigen::Vector3i>& triangles, Points positions);

  /// Moves the vertices and makes the triangles Delaunay again. Nothing happens, and false, where a
  /// triangle would not be positive after the move; what lies between does not matter.
  bool move_to(const Points& positions);

  /// Of the edges as they were, in their order.
  std::vector<Curve> curves() const;

 private:
  /// What comes next on a curve: the number of a crossing, or ~v for the vertex v at its end.
  using Place = int;
  struct Ends {
    Place first, last;
    int from, to;
  };
  struct Crossing {
    int curve;
    Place before, after;
  };
  struct Line {
    int tail = -1;   ///< the vertex from which crossings are in order
    int lying = -1;  ///< the curve that this edge is
    std::vector<int> crossings = {};
  };
  /// A piece of a curve through the two triangles at an edge.
  struct Strand {
    int curve;
    Place before, after;
  };
  /// On which of the two ways from b to d round the quadrilateral a, b, c, d a place is: that by a
  /// or that by c, and how far on.
  struct Rank {
    enum class By { neither, a, c } by = By::neither;
    int rank = 0;
  };

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int before(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int origin(int h) const { return origins_[static_cast<std::size_t>(h)]; }
  int twin(int h) const { return twins_[static_cast<std::size_t>(h)]; }
  const Line& line(int h) const {
    return lines_[static_cast<std::size_t>(edges_[static_cast<std::size_t>(h)])];
  }
  Line& line(int h) {
    return lines_[static_cast<std::size_t>(edges_[static_cast<std::size_t>(h)])];
  }

  /// The quadrilateral a, b, c, d, counter-clockwise, whose diagonal from a to c flips.
  struct Quadrilateral {
    int ab, bc, cd, da;  ///< half-edges of its sides
  };
  Quadrilateral quadrilateral(int diagonal) const;
  /// `changed`: the triangles that may not be Delaunay.
  void make_delaunay(std::vector<bool> changed);
  bool is_better_flipped(const Quadrilateral& q) const;
  void flip(int diagonal);
  /// Curves over a diagonal that was flipped.
  void lead_over(Line& flipped, const Quadrilateral& q);
  void flip_triangles(int diagonal, const Quadrilateral& q);
  void mark_sides(const Quadrilateral& q);
  void mark_side(int from, int side, Rank::By by);
  void unmark_sides();
  Rank rank_of(Place place, const Quadrilateral& q) const;
  void find_strands(const Quadrilateral& q, const Line& diagonal);
  int add_crossing(const Strand& strand);
  void remove_crossing(int crossing);
  void join(int curve, Place before, Place after);

  Points positions_;
  // Of half-edges, three a triangle, counter-clockwise.
  std::vector<int> origins_, twins_, edges_;
  std::vector<Line> lines_;  ///< by edge
  std::vector<Ends> curves_;
  std::vector<Crossing> crossings_;
  std::vector<int> free_;  ///< crossings that are no more
  // While an edge flips.
  std::vector<Rank> ranks_;         ///< by crossing
  std::vector<Place> by_a_, by_c_;  ///< in their order from b to d
  Rank rank_of_a_, rank_of_c_;
  std::vector<Strand> strands_;
};

}  // namespace foldless
