// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/solve/newton_step.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// Whether the factor of one ∇²E may serve several steps.
enum class FactorUse {
  lagged,  ///< it may, by conjugate gradients
  own      ///< every step has a factor of its own: Newton's method to the letter
};

/// Newton's method without damping, as the steps of one stage. It begins with the exact ∇²E, until
/// that is not positive definite. Then comes that without any negative curvature of an element, on
/// which a step makes little way where curvature is negative. After so many full steps with it,
/// twice as many each time this fails again, one half of the negative curvature is left in, and
/// with every further full step more of it, up to the exact ∇²E.
class Descent {
 public:
  explicit Descent(FactorUse use = FactorUse::lagged) : use_(use) {}

  /// One step, of the least clamping that is due; where ∇²E is not positive definite with it, one
  /// with the curvature of every element clamped. Moves the deformed positions of `mesh`; they stay
  /// feasible on the whole way. Counts H and U.
  VertexUpdate step(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                    const std::stop_token& token);

 private:
  std::optional<Points> step_if_definite(NewtonSystem& system, const std::stop_token& token) const;
  void after_partly_clamped(double step_length);
  void after_failure();
  void after_clamped(double step_length);

  FactorUse use_;
  double clamping_ = 0;        ///< part of the negative curvature that is taken away
  int full_steps_ = 0;         ///< with all of it taken away, since less was tried
  int full_steps_wanted_ = 1;  ///< before less is tried again
  double last_shift_ = 0;      ///< that the clamped ∇²E needed
};

/// A step of ∇²E as last assembled with clamped elements, from the roughest factor that does, with
/// which `lagged` makes it; nothing where none is worth while, or all were found too rough, or when
/// cancelled. Counts H.
std::optional<LaggedStep> rough_clamped_step(
    NewtonSystem& system, const std::stop_token& token,
    const std::function<std::optional<LaggedStep>()>& lagged);
/// Factorizes ∇²E as last assembled with clamped elements: the shift that rounding made necessary,
/// tried from the one before `last_shift` on, or nothing when cancelled or hopeless. Counts H.
std::optional<double> factorize_clamped(NewtonSystem& system, const std::stop_token& token,
                                        double last_shift = 0);

}  // namespace foldless
