// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// How many ways from the start of a problem compete with the one that arrived first where the
/// shape that it found is poor.
inline constexpr int kCandidates = 3;
/// Each until it has taken so many factorizations,
inline constexpr int kMostOfACandidate = 30;
/// of a mesh of at most so many triangles.
inline constexpr int kLargestWithCandidates = 3000;

/// One of them, from the mesh as it is: an approach in four straight legs, the first transport, an
/// approach in eight.
Steps<Progress> candidate(int which, Workspace& work);

/// Takes steps until they have ended, or taken so many factorizations: nothing then.
Steps<std::optional<Progress>> within(int most_factorizations, const Effort& effort,
                                      Steps<Progress> steps);

/// Whether E_d is lower by more than rounding and no triangle more distorted than the worst of the
/// other.
bool is_better(const Workspace& work, const Workspace& other);

}  // namespace foldless
