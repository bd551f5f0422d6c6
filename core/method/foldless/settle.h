// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"

namespace foldless {

/// The last stage: the handles are on their targets and stay there, eliminated from the unknowns;
/// Newton's method goes down to the minimum of the scene's energy, with flips on the way. Arrives
/// when neither moves nor flips gain anything.
class Settle {
 public:
  explicit Settle(Workspace& workspace);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);
  /// The handles as the energy sees them in this stage.
  const Positions& positions() const { return held_; }

  /// E with the handles held.
  double energy_of(const Workspace& workspace) const;

 private:
  Positions held_;
  int steps_ = 0;
};

}  // namespace foldless
