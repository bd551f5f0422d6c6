// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/construct/carried_curves.h"
#include "core/construct/slits.h"
#include "core/construct/triangulated_disk.h"

namespace foldless {

/// Slits along edges at rest, which are the curves when deformed: those that join all vertices
/// inside to the outline and are the shortest in both.
SlitDisks slit_along(const std::vector<CarriedCurves::Curve>& curves, const TriangulatedDisk& disk);

}  // namespace foldless
