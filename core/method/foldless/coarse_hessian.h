// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/method/foldless/workspace.h"
#include "core/solve/hessian_factor.h"

namespace foldless {

/// What preconditions the first steps on a fine mesh that took over the map of a coarse one: ∇²E of
/// that as it was assembled last, which is taken from it. A vertex of the fine mesh moves as the
/// point of the coarse one where it is at rest, in triangle `holding`, −1 for none; hard handles,
/// which are vertices of both, do not move. Nothing where the coarse mesh does not serve.
std::optional<CoarseHessian> coarse_hessian(Workspace& coarse, const std::vector<int>& holding,
                                            const MeshPair& fine);

}  // namespace foldless
