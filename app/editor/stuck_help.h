// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/draft.h"
#include "app/editor/messages.h"
#include "app/editor/stuck.h"

namespace foldless {

/// Why a handle of a draft does not get to its target, and what helps.
class StuckHelp {
 public:
  /// Keeps references.
  StuckHelp(Draft& draft, Messages& messages) : draft_(draft), messages_(messages) {}

  /// Brings it up to date; `rests` tells that the newest state is shown and will stay as it is.
  void update(bool rests);

  const std::vector<StuckHandle>& handles() const { return stuck_.handles(); }
  /// The stuck handle that is talked about: the selected one, or the farthest; null without any.
  const StuckHandle* handle() const;
  /// Whether the user wants to be told.
  bool is_shown() const { return stuck_.is_shown(); }
  void toggle();

  void flip_blocking();   ///< the edges that block it; an undo step
  void split_blocking();  ///< as the paper's rule does; an undo step

 private:
  Draft& draft_;
  Messages& messages_;
  StuckHandles stuck_;
};

}  // namespace foldless
