// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A triangulated disk that is cut open along ways from its outline to vertices inside, until none
/// is left there. A vertex that is cut becomes two; the outline goes round both banks of a cut.
class CutDisk {
 public:
  /// A way from a corner of the outline to a vertex inside, across edges in their middles.
  struct Way {
    int corner;                 ///< vertex
    std::vector<Edge> crossed;  ///< from the corner on
  };

  /// All that are the shortest to their corners.
  class Ways {
   public:
    /// Infinite where there is none.
    double cost(int corner) const;

   private:
    friend class CutDisk;
    struct Reached {
      double cost;
      std::uint64_t before;  ///< the directed edge that was crossed last, or kStart
    };
    std::unordered_map<std::uint64_t, Reached> edges_;
    std::unordered_map<int, Reached> corners_;
  };

  /// A disk with the outline `polygon` and, as the next vertices, points inside. Nothing where the
  /// polygon bounds no disk, or a point is not in exactly one place of it, or on another one.
  static std::optional<CutDisk> over(const Points& polygon, const Points& inside);

  /// Vertices counter-clockwise; the first copies have the place in front.
  const std::vector<int>& outline() const { return outline_; }
  /// The vertex that one was before it was cut.
  int origin(int v) const { return origins_[static_cast<std::size_t>(v)]; }
  Vec2 position(int v) const { return positions_[static_cast<std::size_t>(v)]; }
  int vertex_count() const { return static_cast<int>(positions_.size()); }
  const std::vector<Eigen::Vector3i>& triangles() const { return triangles_; }

  /// From the outline to a vertex inside.
  Ways ways_to(int v) const;
  /// Whether an edge joins it to a vertex from `first` on or to `other`.
  bool is_beside(int v, int first, int other) const;
  Way way_from(int corner, const Ways& ways) const;
  /// Cuts along the way to `v`, with at least so many vertices between its ends, which then follow
  /// the others; returns the vertices of the way from the corner on.
  std::vector<int> cut(const Way& way, int v, int least_between);

 private:
  class Search;

  CutDisk() = default;

  /// The triangle on the left of a directed edge; −1 outside.
  int left_of(int a, int b) const;
  /// Its third corner.
  int opposite(int t, int a, int b) const;

  void set_triangle(int t, const Eigen::Vector3i& corners);
  int add_vertex(const Vec2& position);
  int face_count() const { return static_cast<int>(triangles_.size()); }
  /// A new vertex on an interior edge.
  int split(int a, int b, double t);
  void put_on_edge(int v, int a, int b);
  std::vector<int> triangles_at(const Vec2& p) const;
  bool insert(int v);
  void make_delaunay();
  bool flip_if_better(int a, int b);
  void divide(std::vector<int>& way, int least_between);
  void open(const std::vector<int>& way);

  std::vector<Vec2> positions_;
  std::vector<int> origins_;
  std::vector<Eigen::Vector3i> triangles_;
  std::unordered_map<std::uint64_t, int> left_;  ///< triangles by directed edge
  std::vector<int> outline_;
  std::vector<bool> is_on_outline_;  ///< by vertex
  double diagonal_ = 1;
};

}  // namespace foldless
