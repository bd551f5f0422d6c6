// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/solve/newton_system.h"

namespace foldless {

/// Orders the unknowns for the pattern as last assembled, where that is not done: what comes before
/// a factorization, so that a cancellation need not wait for both.
void analyze(NewtonSystem& system);
/// Factorizes ∇²E + μI as last assembled; false when it is not positive definite. Counts H.
bool factorize(NewtonSystem& system, double mu, Precision precision = Precision::full);

/// −(factor)⁻¹ ∇E as displacements of the vertices, 2 × #V. Precondition: factorize() succeeded in
/// full precision.
Points newton_step(NewtonSystem& system);
/// The same where the held handles move by `way`, 2 × #V and zero elsewhere, and the others follow
/// it: −(factor)⁻¹ (∇E + ∇²E way) with the handles' part of ∇²E at `u`, clamped, and `way` itself
/// at the handles.
Points carrying_step(NewtonSystem& system, const EnergySettings& settings, const Points& u,
                     const Points& way);

/// A step from the factor of an earlier ∇²E, or from one that is not in full precision.
struct LaggedStep {
  Points step;                 ///< displacements of the vertices, 2 × #V
  bool is_indefinite = false;  ///< no step: ∇²E turned out not to be positive definite
};

/// newton_step() by conjugate gradients from the factor that there is, where that is near enough:
/// in less precision, or of an earlier ∇²E of the same energy but for α and the conformal weight,
/// with the same handles held.
std::optional<LaggedStep> lagged_newton_step(NewtonSystem& system);
/// carrying_step() in that way.
std::optional<LaggedStep> lagged_carrying_step(NewtonSystem& system, const EnergySettings& settings,
                                               const Points& u, const Points& way);

/// ∇E · step.
double slope(const NewtonSystem& system, const Points& step);

}  // namespace foldless
