// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// How much a map distorts, over all triangles. [dimensionless]
struct Quality {
  double min_area_ratio = 1;             ///< smallest A′/A
  double max_conformal_distortion = 1;   ///< largest σ₁/σ₂
  double mean_conformal_distortion = 1;  ///< mean σ₁/σ₂, every triangle counting the same
};

/// Precondition: the mesh has a triangle and is locally injective.
Quality quality_of(const Triangles& triangles, const Points& rest, const Points& deformed);

}  // namespace foldless
