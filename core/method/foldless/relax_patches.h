// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/method/foldless/workspace.h"

namespace foldless {

/// Lowers E round the given triangles of a large mesh while the rest stays: Newton's method on
/// every patch of some rings of vertices by itself, each as far as its own triangles let it, which
/// is nonlinear elimination [LRW96]. Handles stay where they are, and so do boundary vertices, so
/// that no gap changes. Nothing where the patches would be most of the mesh. A cancelled call keeps
/// what was gained. Counts H and U.
void relax_patches(Workspace& work, const Energy& energy, const std::vector<int>& triangles,
                   const std::stop_token& token);

}  // namespace foldless
