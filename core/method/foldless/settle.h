// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"
#include "core/solve/descent.h"

namespace foldless {

/// How a stage at the targets descends.
struct SettleSettings {
  /// ε: a percent off every k is worth 2 ε percent of E.
  double exponent = 0.08;
  /// q of conformal_power_value(): the larger it is, the more the most distorted triangles count.
  int power = 2;
  /// The k below which less distortion is worth next to nothing; 0 for none.
  double enough = 0;
  FactorUse use = FactorUse::lagged;
};

/// The handles are where they are to stay, eliminated from the unknowns; Newton's method lowers
/// E Kᵉ, with flips on the way: K = (b + Σ k^q)^(2/q) over the triangles, each counting the same,
/// where b is `enough` to the power of q, and the exponent ε says what part of E lower distortions
/// are worth. Small triangles weigh next to nothing in E, however distorted. Vertices of splits
/// move at rest, too. Ends when neither moves nor flips gain anything.
Steps<> settle(Workspace& work, SettleSettings settings = {});

/// E of the scene with the handles held.
double settled_energy(const Workspace& work);
/// E Kᵉ, with the mean in place of the sum so that it can be compared when triangles went.
double merit_of(const Workspace& work, double exponent = SettleSettings().exponent);

}  // namespace foldless
