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
inline constexpr int kMostOfACandidate = 40;
/// of a mesh of at most so many triangles.
inline constexpr int kLargestWithCandidates = 3000;

/// One of them, from the mesh as it is: an approach in two straight legs, the first transport, an
/// approach in eight.
Steps<Progress> candidate(int which, Workspace& work);

/// All of them from a mesh, where the largest σ₁/σ₂ is above 100 and the mesh not too large; one
/// with less E_d, within most_distortion_beside() the first, takes the place.
Steps<> try_candidates(Workspace& work, const MeshPair& start);

/// Takes steps until they have ended, or taken so many factorizations: nothing then.
Steps<std::optional<Progress>> within(int most_factorizations, const Effort& effort,
                                      Steps<Progress> steps);

/// Whether E_d is lower by more than rounding.
bool has_less_energy(const Workspace& work, const Workspace& other);

/// The largest σ₁/σ₂ of what may take the place of a mesh: half again as much as of the mesh,
/// unless that were crushed. Of the first mesh for all candidates, so that their order does not
/// count.
double most_distortion_beside(const MeshPair& mesh);

}  // namespace foldless
