// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"

namespace foldless {

/// The stage for handles that could not be carried home: minimises E under a penalty α that grows
/// from weak to the paper's, so that the whole mesh follows the handles before they press on the
/// triangles next to them. Arrives when the handles can be put exactly on their targets.
class Approach {
 public:
  explicit Approach(Workspace& workspace);
  Progress step(Workspace& workspace, std::stop_token token, VertexUpdate& update);

 private:
  Progress after_step(Workspace& workspace, const VertexUpdate& update);
  Progress at_full_penalty(Workspace& workspace, double error, bool is_settled);
  void start_alpha(Workspace& workspace, double alpha);

  Positions aimed_;  ///< the targets minus the multipliers / 2α
  double alpha_ = 0;
  int multiplier_steps_ = 0;
  double watched_error_ = 0;  ///< ‖P‖² when the stall watch began
  int watched_steps_ = 0;
};

}  // namespace foldless
