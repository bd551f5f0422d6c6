// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/handle.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// True when some handle has a depth: without any, nothing is said about what lies in front.
bool has_depths(const std::vector<Handle>& handles);

/// The depth of every vertex: the harmonic function on the rest mesh that has the depths of the
/// handles at their vertices; 0 in a component without a handle. An edge whose two cotangents add
/// up to nearly nothing or less gets a small weight instead, so that no value lies outside those of
/// the handles even where flips have left needles in the rest mesh. Precondition: handles name
/// vertices that triangles use.
Eigen::VectorXd depth_field(const Triangles& triangles, const Points& rest,
                            const std::vector<Handle>& handles);

/// The depths of one mesh after another. What flips and splits make of a mesh keeps the function on
/// the rest mesh as it is, without a solve; vertices made by splits take the mean of their
/// neighbours.
class DepthField {
 public:
  /// As depth_field(), valid until the next call.
  const Eigen::VectorXd& update(const Triangles& triangles, const Points& rest,
                                const std::vector<Handle>& handles);

 private:
  bool holds(const Points& rest, const std::vector<Handle>& handles) const;
  bool extend(const Triangles& triangles, Eigen::Index count);

  std::vector<Handle> handles_;
  Points rest_;
  Eigen::VectorXd depth_;
};

}  // namespace foldless
