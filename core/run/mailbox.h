// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stop_token>
#include <utility>

#include "core/run/inbox.h"

namespace foldless {

/// The worker's inbox, and which messages cancel the iteration that runs. Not synchronized.
class Mailbox {
 public:
  enum class Cancels {
    always,
    once,  ///< not where the iteration before was cancelled, so that a stream cannot starve the run
    never
  };

  /// Calls `change` with the inbox.
  template <typename Change>
  void post(Cancels cancels, const Change& change) {
    change(inbox_);
    if (cancels == Cancels::always || (cancels == Cancels::once && !last_was_cancelled_))
      cancel_iteration();
  }
  /// Counts the loads from 1.
  std::uint64_t next_generation() { return ++last_generation_; }

  bool is_empty() const { return inbox_.is_empty(); }
  bool has_load() const { return inbox_.load != nullptr; }
  /// The messages; none is left.
  Inbox collect() { return std::exchange(inbox_, {}); }

  /// A message that comes from here on finds the stop source of the iteration it may cancel.
  std::stop_token begin_iteration() {
    iteration_stop_ = std::stop_source();
    return iteration_stop_.get_token();
  }
  void end_iteration(bool was_cancelled) { last_was_cancelled_ = was_cancelled; }
  void cancel_iteration() { iteration_stop_.request_stop(); }

 private:
  Inbox inbox_;
  std::stop_source iteration_stop_;  ///< of the running iteration, or of one that has ended
  bool last_was_cancelled_ = false;  ///< the iteration before the running one
  std::uint64_t last_generation_ = 0;
};

}  // namespace foldless
