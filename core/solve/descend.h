// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/solve/update_vertices.h"

namespace foldless {

/// Which ∇²E the next step of descend() begins with. Where the exact one was not positive definite,
/// it is tried again after so many full steps with the clamped one, twice as many each time it
/// fails again.
struct CurvatureChoice {
  Curvature next = Curvature::exact;
  int full_steps = 0;         ///< with the clamped ∇²E since the exact one was tried
  int full_steps_wanted = 1;  ///< before it is tried again
  double last_shift = 0;      ///< that the clamped ∇²E needed
};

/// Factorizes ∇²E as last assembled with clamped elements: the shift that rounding made necessary,
/// tried from the one before `last_shift` on, or nothing when cancelled or hopeless. Counts H.
std::optional<double> factorize_clamped(NewtonSystem& system, std::stop_token token,
                                        double last_shift = 0);

/// One step of Newton's method without damping: with the exact ∇²E where that is positive definite,
/// else with the curvature of every element clamped. Moves the deformed positions of `mesh`; they
/// stay feasible on the whole way. Counts H and U.
VertexUpdate descend(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                     CurvatureChoice& choice, std::stop_token token);

}  // namespace foldless
