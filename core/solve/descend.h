// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/solve/update_vertices.h"

namespace foldless {

/// Which ∇²E the next step of descend() begins with: the exact one, until it is not positive
/// definite. Then that without any negative curvature of an element, on which a step makes little
/// way where curvature is negative. After so many full steps with it, twice as many each time this
/// fails again, one half of the negative curvature is left in, and with every further full step
/// more of it, up to the exact ∇²E.
struct CurvatureChoice {
  double clamping = 0;        ///< part of the negative curvature that is taken away
  int full_steps = 0;         ///< with all of it taken away, since less was tried
  int full_steps_wanted = 1;  ///< before less is tried again
  double last_shift = 0;      ///< that the clamped ∇²E needed
};

/// Factorizes ∇²E as last assembled with clamped elements: the shift that rounding made necessary,
/// tried from the one before `last_shift` on, or nothing when cancelled or hopeless. Counts H.
std::optional<double> factorize_clamped(NewtonSystem& system, std::stop_token token,
                                        double last_shift = 0);

/// One step of Newton's method without damping, with ∇²E as `choice` has it where that is positive
/// definite, else with the curvature of every element clamped. Moves the deformed positions of
/// `mesh`; they stay feasible on the whole way. Counts H and U.
VertexUpdate descend(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                     CurvatureChoice& choice, std::stop_token token);

}  // namespace foldless
