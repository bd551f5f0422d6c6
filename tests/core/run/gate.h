// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "tests/support/patience.h"

namespace foldless::test {

/// A place in a script where the solver thread waits until the test lets it on, so that what the
/// test does meanwhile is certain to come during an iteration, however slow the machine is.
class Gate {
 public:
  /// On the solver thread: waits to be let through.
  void pass() {
    std::unique_lock lock(mutex_);
    const int mine = ++arrived_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return is_open_ || mine <= let_through_; });
  }
  /// Waits until the solver is at the gate; false when it never comes.
  bool holds_the_solver() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] { return arrived_ > let_through_; });
  }
  void let_through() {
    std::lock_guard lock(mutex_);
    ++let_through_;
    changed_.notify_all();
  }
  /// For good.
  void open() {
    std::lock_guard lock(mutex_);
    is_open_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int arrived_ = 0;
  int let_through_ = 0;
  bool is_open_ = false;
};

}  // namespace foldless::test
