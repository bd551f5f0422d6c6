// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <ctime>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace foldless {

/// When a run is to be stopped from outside.
struct StopConditions {
  std::optional<double> time_limit;      ///< processor seconds of the thread that is watched
  std::function<bool()> is_interrupted;  ///< asked a hundred times a second, on another thread
};

/// Sets a stop token when it is time to stop what the thread does that made the watch.
class StopWatch {
 public:
  explicit StopWatch(StopConditions conditions);

  std::stop_token token() const { return stop_.get_token(); }
  /// True once the time limit has set the token.
  bool is_time_over() const { return is_time_over_; }

 private:
  void watch(const std::stop_token& ending, clockid_t clock);

  StopConditions conditions_;
  std::stop_source stop_;
  std::atomic<bool> is_time_over_ = false;
  std::mutex mutex_;
  std::condition_variable_any pause_;  ///< made here: the thread is to need no memory
  std::jthread thread_;                ///< the last member: it ends before the others do
};

/// The processor time of the calling thread, as a clock that other threads can read.
clockid_t own_clock();
/// What a clock shows. [s]
double seconds_on(clockid_t clock);

}  // namespace foldless
