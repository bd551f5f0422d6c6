// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/method.h"
#include "core/method/steps.h"
#include "core/solve/effort.h"

namespace foldless {

/// A method that is written as a coroutine: step() goes on with it for one vertex update.
class SteppedMethod : public Method {
 public:
  std::optional<Iteration> step(const std::stop_token& token) final;
  std::optional<Outcome> outcome() const final { return outcome_; }
  /// The stages by the clock on the wall, times the part of it that was the thread's.
  StageTimes times() const final;
  /// All that it has spent so far.
  const Effort& spent() const { return effort_; }

 protected:
  /// Leaves what it was about and begins with this: up to its first update.
  void begin(Steps<Outcome> steps);
  /// What the method has spent; its systems add to it.
  Effort& effort() { return effort_; }

 private:
  /// By the clock on the wall.
  virtual StageTimes stage_times() const { return effort_.times; }
  void see_whether_ended();

  Effort effort_;
  StepContext context_;
  std::optional<Steps<Outcome>> steps_;
  std::optional<Outcome> outcome_;
  double seconds_ = 0;       ///< of the thread
  double wall_seconds_ = 0;  ///< that passed meanwhile
};

}  // namespace foldless
