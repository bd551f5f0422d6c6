// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/method/foldless/workspace.h"
#include "core/solve/descent.h"

namespace foldless {

/// The descent of one stage, with flips on the way: where a step was short, and every few steps.
class FlippingDescent {
 public:
  explicit FlippingDescent(FactorUse use) : descent_(use) {}

  VertexUpdate step(Workspace& work, const Energy& energy, const std::stop_token& token);
  /// Flips now, whatever it gains.
  void flip(Workspace& work, const EnergySettings& energy);

 private:
  Descent descent_;
  int steps_since_flips_ = 0;
};

}  // namespace foldless
