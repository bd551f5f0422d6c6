// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stage_times.h"

namespace foldless {

/// What a run has done and spent, on whichever mesh: only ever added to. A method has one; all that
/// works for it adds to that.
struct Effort {
  int steps = 0;           ///< recorded
  int rounds = 0;          ///< of splits, and other ways that were tried
  int factorizations = 0;  ///< H of Table 1: every attempt
  int updates = 0;         ///< U of Table 1: every accepted update
  int flips = 0;           ///< edges flipped
  int splits = 0;          ///< edges split
  StageTimes times;

  friend Effort operator+(Effort a, const Effort& b) {
    a.steps += b.steps;
    a.rounds += b.rounds;
    a.factorizations += b.factorizations;
    a.updates += b.updates;
    a.flips += b.flips;
    a.splits += b.splits;
    a.times += b.times;
    return a;
  }
};

}  // namespace foldless
