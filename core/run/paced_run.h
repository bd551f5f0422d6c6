// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "core/method/method.h"
#include "core/run/inbox.h"
#include "core/run/run.h"
#include "core/run/worker_status.h"
#include "core/snapshot.h"

namespace foldless {

/// The run that the worker's messages are about, whether it may go on and how fast. What fails ends
/// the run; status() says why.
class PacedRun {
 public:
  using Clock = std::chrono::steady_clock;
  struct Step {
    std::optional<Iteration> iteration;  ///< nothing: cancelled, ended or failed
    bool was_cancelled = false;
  };

  explicit PacedRun(MethodStarter start);

  /// Does what the messages ask for, in the order of Inbox's members; the mode first, which holds
  /// whatever fails after it.
  void apply(const Inbox& messages);
  /// An iteration may begin: the run has no outcome, and it is running or one step is asked for.
  bool can_iterate() const;
  /// When the pace lets the next iteration begin; nothing: at once. Steps of Phase::walk are no
  /// faster than pictures are drawn.
  std::optional<Clock::time_point> next_start() const;
  Step iterate(const std::stop_token& token);
  /// The run cannot go on, for this reason.
  void end_because(std::string words);

  std::shared_ptr<const Snapshot> snapshot() const;  ///< the run's newest, or null
  WorkerStatus status() const;

 private:
  template <typename Task>
  void end_where_it_throws(const Task& task);
  void set_pace(std::optional<double> iterations_per_second);
  void change_run(const Inbox& messages);

  const MethodStarter start_;
  std::optional<Run> run_;
  std::uint64_t generation_ = 0;
  WorkerMode mode_ = WorkerMode::idle;
  bool step_ = false;
  std::string error_;
  std::optional<Clock::duration> period_;
  bool is_walking_ = false;  ///< the last iteration was a step that is to be watched
  std::optional<Clock::time_point> last_start_;  ///< of an iteration
};

}  // namespace foldless
