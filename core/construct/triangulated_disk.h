// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// A triangulated disk, whose outline are the vertices 0, 1, …, corners − 1, counter-clockwise, and
/// the positions of its vertices at rest and deformed.
struct TriangulatedDisk {
  std::vector<Eigen::Vector3i> triangles;  ///< at rest
  int corners;
  Points rest, deformed;
};

}  // namespace foldless
