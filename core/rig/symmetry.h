// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rig/mirror_axis.h"

namespace foldless {

/// The axis in which a rest mesh (2 × #V) lies over itself best, from one side of it to the other.
/// Of axes that are as good an upright one comes first, then a level one. Precondition: there is a
/// triangle.
MirrorAxis symmetry_axis(const Triangles& triangles, const Points& rest);

/// Through the middle of the mesh's area in a direction (of any length), as long as the mesh there.
MirrorAxis axis_through_middle(const Triangles& triangles, const Points& rest,
                               const Vec2& direction);

}  // namespace foldless
