// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/depth/overlaps.h"

namespace foldless {

/// What decides which of two sheets lies in front, by triangle.
struct PaintKeys {
  Eigen::VectorXd depth;  ///< the larger is in front
  Eigen::VectorXd order;  ///< where depths are equal
};

/// A layer for every triangle, 0 at the back and as few as it takes: triangles of one layer do not
/// overlap, and of two that do the one in front has the higher layer.
/// A connected piece of the overlap is ordered as one, by the mean depths of its two sheets, so
/// that they never interleave. Where pieces contradict each other round a circle, triangles behind
/// by the keys come first.
std::vector<int> paint_layers(const Triangles& triangles, std::span<const Overlap> overlaps,
                              const PaintKeys& keys);

}  // namespace foldless
