// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/iteration.h"
#include "core/method/method.h"
#include "core/snapshot.h"

namespace foldless {

/// What the worker is doing.
enum class WorkerState {
  idle,     ///< nothing loaded, or stopped before the end
  running,  ///< iterating
  paused,   ///< waiting for run() or step()
  finished  ///< the run has an outcome
};

/// State of the worker at one moment, a value.
struct WorkerStatus {
  WorkerState state = WorkerState::idle;
  std::uint64_t generation = 0;    ///< of the newest load that the worker has taken up
  std::optional<Outcome> outcome;  ///< when finished
  bool satisfied = false;          ///< every handle that is not soft is at its target
  std::string error;               ///< one sentence when the run could not go on, else empty
};

/// One iteration on the timeline. The record is always there; the snapshot is null where it was
/// let go because the memory cap was reached.
struct TimelineEntry {
  Iteration record;
  std::shared_ptr<const Snapshot> snapshot;
};

/// A solver thread with an inbox. All functions return at once and may be called from one other
/// thread (the window's); the solving itself is never waited for.
///
/// Contract: a newer message of the same kind replaces an older one that was not yet taken; a
/// running iteration is cancelled for load, stop and set_targets, noticed between factorizations;
/// whatever is cancelled, the newest snapshot is a valid mesh. `wake` is called on the solver
/// thread after something new can be read; it must not block.
class Worker {
 public:
  explicit Worker(std::function<void()> wake = {});
  ~Worker();  ///< cancels and joins
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Replaces the problem and returns its generation number; the state (running or paused) stays,
  /// a finished run begins to run. The first snapshot is the problem's own mesh.
  std::uint64_t load(Problem problem);
  /// Moves the targets in the order of the problem's handles; a finished run begins to run again.
  void set_targets(Points targets);
  /// Same mesh, other energy or parameters.
  void set_parameters(const Density* energy, Parameters parameters);
  void run();
  void pause();
  /// One iteration more, then pause.
  void step();
  /// Ends the run where it is: state idle, the snapshot stays.
  void stop();
  /// At most this many iterations a second; nothing: as fast as it goes.
  void set_pace(std::optional<double> iterations_per_second);

  /// The newest valid snapshot, or null before the first load.
  std::shared_ptr<const Snapshot> latest() const;
  WorkerStatus status() const;
  /// The iterations since the last load() or clear_timeline(), complete and in order, from index
  /// `first` on.
  std::vector<TimelineEntry> timeline(std::size_t first = 0) const;
  /// Counts the timeline's starts, so that a reader knows that its copy is out of date.
  std::uint64_t timeline_epoch() const;
  /// Starts the timeline anew: the next iteration is its first. An edit (a drag) begins with it.
  void clear_timeline();
};

}  // namespace foldless
