// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/method/method.h"
#include "core/run/channel.h"
#include "core/run/mailbox.h"
#include "core/run/paced_run.h"
#include "core/run/timeline.h"
#include "core/run/worker_status.h"
#include "core/snapshot.h"
#include "core/threads/team.h"

namespace foldless {

struct WorkerOptions {
  std::size_t timeline_bytes = std::size_t{180} << 20;  ///< memory cap of the timeline's snapshots
  MethodStarter start = start_method;
  /// That solve together: all cores but the window's.
  int threads = std::max(1, cores() - 1);
};

/// A solver thread with an inbox. All functions return at once and may be called from one other
/// thread (the window's); the solving itself is never waited for, and no lock is held meanwhile.
///
/// Contract: a newer message of the same kind replaces an older one that was not yet taken; all
/// messages are taken before the next iteration begins. A running iteration is cancelled for load,
/// stop, set_targets and set_parameters, noticed between factorizations; an iteration that follows
/// a cancelled one is left to end for new targets and parameters, so that a stream of them cannot
/// hold up the solver. Whatever is cancelled, the newest snapshot stands. `wake` is
/// called on the solver thread after something new can be read, until the destructor has returned;
/// it must neither block nor throw.
class Worker {
 public:
  explicit Worker(std::function<void()> wake = {}, WorkerOptions options = {});
  ~Worker();  ///< cancels and joins
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Replaces the problem and returns its generation number; clears the timeline. The mode
  /// that was asked for last goes on to hold: a finished run that was not paused begins
  /// to run. The first snapshot is the problem's own mesh. Targets and parameters that the worker
  /// has not yet taken up are dropped.
  std::uint64_t load(Problem problem);
  /// Moves the targets in the order of the problem's handles (2 × #handles) and turns those that
  /// turn, see Run::set_targets(); a finished run begins to run again unless it was paused. The
  /// newest snapshot shows them.
  void set_targets(Points targets, std::vector<double> angles = {});
  /// Same mesh, other energy or parameters: a new run from where this one is, begun likewise.
  void set_parameters(const Density* energy, Parameters parameters);
  /// Runs, pauses, or ends the run where it is: idle, the snapshot stays, and running would go on.
  void set_mode(WorkerMode mode);
  /// One iteration more, then pause.
  void step();
  /// At most this many iterations a second, > 0; nothing: as fast as it goes. step() does not wait.
  void set_pace(std::optional<double> iterations_per_second);

  /// The newest snapshot, or null before the first load was taken up: valid, or marked as not when
  /// the method may fold.
  std::shared_ptr<const Snapshot> latest() const { return snapshots_.latest(); }
  WorkerStatus status() const;
  /// The iterations begun since the last load() or clear_timeline(), complete and in order, from
  /// index `first` on.
  TimelinePart timeline(std::size_t first = 0) const;
  /// Starts the timeline anew: the next iteration to begin is its first. An edit (a drag) begins
  /// with it.
  void clear_timeline();

 private:
  template <typename Change>
  void post(Mailbox::Cancels cancels, const Change& change);

  // On the solver thread.
  void work(const std::stop_token& stopping);
  /// Takes the messages, or does an iteration; false when the worker is to end.
  bool take_turn(const std::stop_token& stopping);
  void wait_for_something_to_do(std::unique_lock<std::mutex>& lock,
                                const std::stop_token& stopping);
  void iterate(const std::stop_token& token, std::uint64_t epoch);
  void publish_status();
  void publish_failure();

  const std::function<void()> wake_;
  Channel<Snapshot> snapshots_;

  mutable std::mutex mutex_;  ///< guards the next four
  std::condition_variable_any changed_;
  Mailbox mailbox_;
  WorkerStatus status_;
  Timeline timeline_;

  const int threads_;
  PacedRun run_;         ///< of the solver thread alone
  std::jthread thread_;  ///< last, so that it is joined before anything else goes
};

}  // namespace foldless
