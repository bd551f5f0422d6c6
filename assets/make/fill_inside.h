// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/shape.h"

namespace foldless::samples {

/// The mesh with interior vertices added until it has `vertices`: the longest interior edge is
/// halved, edges flip until the mesh is Delaunay, and in the end interior vertices move between
/// their neighbours. The boundary stays as it is. Lengths that differ by rounding count as equal,
/// so that every machine makes the same mesh.
Shape filled_inside(const Shape& shape, int vertices);

}  // namespace foldless::samples
