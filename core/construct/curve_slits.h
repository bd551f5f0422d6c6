// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/construct/carried_curves.h"
#include "core/construct/slits.h"

namespace foldless {

/// A triangulated disk, whose outline are the vertices 0, 1, …, corners − 1, counter-clockwise, and
/// the positions of its vertices at rest and deformed.
struct TriangulatedDisk {
  std::vector<Eigen::Vector3i> triangles;  ///< at rest
  int corners;
  Points rest, deformed;
};

/// Slits along edges at rest, which are the curves when deformed: those that join all vertices
/// inside to the outline and are the shortest in both.
SlitDisks slit_along(const std::vector<CarriedCurves::Curve>& curves, const TriangulatedDisk& disk);

}  // namespace foldless
