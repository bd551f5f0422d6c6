// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace foldless {

/// One thread for jobs of which only the newest counts: starting one asks the running one to stop
/// and drops those that were not yet begun. Functions return at once, but the destructor waits for
/// a job to notice that it was asked to stop. A job tells of its failures itself: what it throws is
/// dropped, and the thread goes on with the next.
class LatestJob {
 public:
  using Job = std::function<void(const std::stop_token& stop)>;

  LatestJob() = default;
  ~LatestJob();
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  void start(Job job);
  /// Asks the running job to stop and drops the one that waits.
  void cancel();

 private:
  void work(const std::stop_token& ended);

  std::mutex mutex_;
  std::condition_variable_any has_news_;
  Job next_;                 ///< empty: none waits
  std::stop_source newest_;  ///< of the job that was started last, which waits, runs or has ended
  std::jthread thread_;      ///< made for the first job
};

}  // namespace foldless
