// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/shape.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// How much a map distorts. [dimensionless]
struct Quality {
  double min_area_ratio = 1;            ///< smallest A′/A, not positive where triangles fold
  double max_conformal_distortion = 1;  ///< largest σ₁/σ₂ of the triangles that are not folded
  double mean_conformal_distortion = 1;  ///< mean σ₁/σ₂ of these, all counting the same
};

/// Precondition: the mesh has a triangle, and those at rest are positive.
Quality quality_of(const Triangles& triangles, const Points& rest, const Points& deformed);

/// σ₁/σ₂ of a triangle, 0 where it is folded. Precondition: it is positive at rest.
double conformal_distortion(const Points& rest, const Points& deformed, const Eigen::Vector3i& t);

/// The smallest angle of all triangles, in degrees; 180 without any, negative when one is
/// clockwise.
double smallest_angle(const Shape& shape);

}  // namespace foldless
