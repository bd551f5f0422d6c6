// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A triangulation at rest that vertices are added to. Every triangle lies in one of those that it
/// began with, its origin.
class GrowingMesh {
 public:
  GrowingMesh(const Triangles& triangles, const Points& rest);

  int vertex_count() const { return static_cast<int>(rest_.size()); }
  int face_count() const { return static_cast<int>(triangles_.size()); }
  const Eigen::Vector3i& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  int origin(int t) const { return origins_[static_cast<std::size_t>(t)]; }
  /// Area over the square of the longest edge, of a triangle at rest.
  double shape(const Eigen::Vector3i& t) const;
  const Vec2& rest(int v) const { return rest_[static_cast<std::size_t>(v)]; }

  /// A vertex on the edge from a to b, or inside of a triangle; it becomes the last. Returns the
  /// triangles that were changed and made; none where one of them would not be counter-clockwise,
  /// or a needle: then nothing was added.
  std::vector<int> split_edge(int a, int b, const Vec2& at);
  std::vector<int> split_triangle(int t, const Vec2& at);
  /// Replaces the edge between two triangles of one origin by the other diagonal, where that makes
  /// the thinner of the two less thin. Returns them; none where it was not replaced.
  std::vector<int> flip_edge(int a, int b);

  Triangles triangles() const;
  Points rest() const;

 private:
  struct Replacement {
    int triangle;
    std::vector<Eigen::Vector3i> parts;
  };
  /// The triangles at an edge.
  std::vector<int> beside(int a, int b) const;
  std::vector<int> replace(const std::vector<Replacement>& replacements, const Vec2& at);
  void enter(int t);
  void leave(int t);

  std::vector<Eigen::Vector3i> triangles_;
  std::vector<int> origins_;
  std::vector<Vec2> rest_;
  std::map<Edge, std::vector<int>> beside_;
};

}  // namespace foldless
