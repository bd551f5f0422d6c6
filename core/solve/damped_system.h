// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/solve/newton_system.h"

namespace foldless {

/// The system of the published methods, with the damping of [SKPSH13]: a shift μ of ∇²E, and a λ
/// that lives from one iteration to the next. `foldless` clamps elements instead, see Descent.
class DampedSystem : public NewtonSystem {
 public:
  DampedSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort);

  /// True when ∇²E itself is positive definite; its factor then serves the next solve. False also
  /// when cancelled.
  bool factorize_plain(const std::stop_token& token);
  /// Factorizes ∇²E + μI for the smallest μ that the damping tries: μ = 0 first unless
  /// `plain_failed` (the caller knows), then λ added cumulatively, ×10 a failure. Nothing when
  /// cancelled or when λ ran out of range, from where it begins anew; else μ.
  std::optional<double> factorize_damped(bool plain_failed, const std::stop_token& token);

 private:
  double lambda_;
};

}  // namespace foldless
