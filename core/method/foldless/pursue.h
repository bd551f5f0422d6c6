// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"

namespace foldless {

/// The first stage, and that of a drag, entered when targets move: the handles are carried to them
/// by Newton steps that have their way on the right-hand side, in one when it is short. Arrives
/// when the handles are exactly on their targets. Locks when steps in a row gain little, with the
/// handles that much nearer.
class Pursue {
 public:
  explicit Pursue(const Workspace& workspace);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);
  /// The handles as the energy sees them in this stage.
  const Positions& positions() const { return held_; }

 private:
  Positions held_;
  int short_steps_ = 0;  ///< in a row
};

}  // namespace foldless
