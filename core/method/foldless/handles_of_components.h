// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy/constraints.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// The handles of each connected component that has some, as indices into `constraints`. Flips and
/// splits do not change them.
std::vector<std::vector<int>> handles_of_components(const MeshPair& mesh,
                                                    const Constraints& constraints);

}  // namespace foldless
