// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/method/method.h"

namespace foldless {

/// What the worker is doing.
enum class WorkerState {
  idle,     ///< nothing loaded, stopped before the end, or ended by an error
  running,  ///< iterating
  paused,   ///< waiting to be told to run, or to step
  finished  ///< the run has an outcome
};

/// State of the worker at one moment, a value.
struct WorkerStatus {
  WorkerState state = WorkerState::idle;
  std::uint64_t generation = 0;    ///< of the newest load that the worker has taken up
  std::optional<Outcome> outcome;  ///< when finished
  std::string verdict;             ///< of the method, when finished; may be empty
  bool satisfied = false;          ///< every handle that is not soft is at its target
  std::string error;               ///< one sentence when the run could not go on, else empty
  bool is_current = true;          ///< false: a message waits that the worker has not taken up

  bool operator==(const WorkerStatus&) const = default;
};

}  // namespace foldless
