// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/remesh/split_edges.h"

namespace foldless {

/// Gives room to the map where it is distorted: of every triangle whose σ₁/σ₂ is `least` or more,
/// the edge is split in its middle that is longest, in M and M′ together, of those that may be;
/// lengths are measured against the size of the triangle there. The map does not change; new
/// vertices are free. The most distorted triangles come first. Returns the number of splits.
int split_distorted(MeshPair& mesh, double least, const SplitSettings& settings);

}  // namespace foldless
