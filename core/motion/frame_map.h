// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// The map of a solved frame over the triangles of the original mesh, whatever flips and splits the
/// frame's own triangulation has seen: it has all original vertices, where they were at rest. What
/// lies in an original triangle is found along edges, so that a rest mesh may lie over itself.
/// Not thread-safe: what is found is kept.
class FrameMap {
 public:
  /// `original`: 3 × #F, which has to outlive the map.
  FrameMap(std::shared_ptr<const Snapshot> snapshot, const Triangles& original);

  const Snapshot& snapshot() const { return *snapshot_; }
  /// The frame's triangles that share area at rest with an original one.
  const std::vector<int>& covering(int triangle) const;
  /// Where the frame takes a point of an original triangle at rest.
  Vec2 at(const Vec2& rest, int triangle) const;

 private:
  std::vector<int> find_covering(int triangle) const;
  std::vector<int> neighbours(int triangle) const;

  std::shared_ptr<const Snapshot> snapshot_;
  const Triangles& original_;
  std::vector<int> first_;  ///< of a vertex in `round_`, #V + 1
  std::vector<int> round_;  ///< triangles by vertex
  mutable std::unordered_map<int, std::vector<int>> covering_;
};

/// True when two counter-clockwise triangles, a corner a column, share area; exact.
bool share_area(const Eigen::Matrix<double, 2, 3>& a, const Eigen::Matrix<double, 2, 3>& b);

/// The corners of a triangle.
inline Eigen::Matrix<double, 2, 3> corners_of(const Points& points, const Eigen::Vector3i& t) {
  Eigen::Matrix<double, 2, 3> corners;
  corners << points.col(t[0]), points.col(t[1]), points.col(t[2]);
  return corners;
}

/// Barycentric coordinates of a point in a triangle that has area; they add up to 1.
Eigen::Vector3d barycentric(const Eigen::Matrix<double, 2, 3>& corners, const Vec2& point);

}  // namespace foldless
