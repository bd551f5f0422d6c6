// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/mesh.h>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// How the vertices of a snapshot lie in the mesh that it was made of, 3 × #F on the first vertices
/// of the snapshot.
Parents parents_of(const Snapshot& snapshot, const Triangles& input);

}  // namespace foldless
