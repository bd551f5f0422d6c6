// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "core/depth/box_grid.h"
#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// Where a remeshed mesh takes points of the mesh that it was made of. Any thread may ask.
class PointMap {
 public:
  /// `input`: 3 × #F of the mesh without remeshing, on the first vertices of the snapshot's rest.
  PointMap(Triangles input, std::shared_ptr<const Snapshot> snapshot);

  /// See Result::map().
  Points at(const Points& points) const;
  /// See Result::map(). `coordinates`: 3 × #P.
  Points at(const Eigen::VectorXi& triangles, const Eigen::Matrix3Xd& coordinates) const;
  const Snapshot& snapshot() const { return *snapshot_; }

 private:
  int triangle_at(const Vec2& point) const;

  Triangles input_;
  std::shared_ptr<const Snapshot> snapshot_;
  double tolerance_ = 0;  ///< of what is outside [length]
  std::vector<Eigen::AlignedBox2d> boxes_;
  BoxGrid grid_;
};

}  // namespace foldless
