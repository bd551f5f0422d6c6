// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/bench_pool.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/run/stop_watch.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// A run that is under way, as the watching thread sees it.
struct Watched {
  clockid_t clock;
  double deadline;  ///< on that clock
  std::stop_source stop;
};

/// Workers take jobs one by one; the calling thread watches their clocks.
class Pool {
 public:
  Pool(const std::vector<BenchJob>& jobs, const BenchOptions& options)
      : jobs_(jobs),
        options_(options),
        rows_(jobs.size()),
        watched_(static_cast<std::size_t>(options.threads)) {}

  std::vector<BenchRow> run(const BenchObserver& observer) {
    std::vector<BenchRow> finished;
    std::vector<std::jthread> workers;
    workers.reserve(watched_.size());
    std::unique_lock lock(mutex_);
    try {
      for (std::size_t i = 0; i < watched_.size(); ++i)
        workers.emplace_back([this, i] { work(i); });
      watch(workers.size(), observer, finished, lock);
    } catch (...) {
      stop_all();  // else the runs would go on to their ends before anybody is told
      throw;
    }
    if (failure_) std::rethrow_exception(failure_);
    return finished;
  }

 private:
  /// Holds the lock but while it waits.
  void watch(std::size_t workers, const BenchObserver& observer, std::vector<BenchRow>& finished,
             std::unique_lock<std::mutex>& lock) {
    while (ended_ < workers) {
      changed_.wait_for(lock, std::chrono::milliseconds(10));
      stop_late_runs();
      if (observer.is_interrupted && observer.is_interrupted()) stop_all();
      report(observer, finished);
    }
    report(observer, finished);  // workers may all have ended before the first look
  }

  void work(std::size_t worker) {
    std::exception_ptr failure;
    try {
      work_off(worker);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (failure) {
      failure_ = failure;
      stop_all();
    }
    ++ended_;
    changed_.notify_one();
  }

  void work_off(std::size_t worker) {
    Team team(options_.team);
    const WithTeam with(&team);
    std::unique_lock lock(mutex_);
    while (next_ < jobs_.size()) {
      const std::size_t index = next_++;
      rows_[index] = repeated(index, worker, lock);
      changed_.notify_one();
    }
  }

  /// Holds the lock but while it runs.
  std::optional<BenchRow> repeated(std::size_t index, std::size_t worker,
                                   std::unique_lock<std::mutex>& lock) {
    std::optional<BenchRow> result;
    std::vector<double> seconds;
    for (int i = 0; i < options_.repeat && !is_stopped_; ++i) {
      Watched watch{own_clock(), 0, {}};
      watch.deadline = seconds_on(watch.clock) + options_.time_limit;
      watched_[worker] = watch;
      lock.unlock();
      BenchRow row = run_job(jobs_[index], watch.stop.get_token());
      lock.lock();
      watched_[worker].reset();
      if (is_stopped_) return std::nullopt;
      if (watch.stop.stop_requested()) row.outcome = "time-limit";
      seconds.push_back(row.seconds);
      if (!result) result = std::move(row);
      if (watch.stop.stop_requested()) break;
    }
    if (!result) return std::nullopt;
    std::ranges::sort(seconds);
    result->job = index;
    result->seconds = seconds[seconds.size() / 2];
    return result;
  }

  void stop_late_runs() {
    for (std::optional<Watched>& watch : watched_)
      if (watch && seconds_on(watch->clock) > watch->deadline) watch->stop.request_stop();
  }

  void stop_all() {
    is_stopped_ = true;
    next_ = jobs_.size();
    for (std::optional<Watched>& watch : watched_)
      if (watch) watch->stop.request_stop();
  }

  /// Passes on the rows that are there; after an interrupt those that will never be are skipped.
  void report(const BenchObserver& observer, std::vector<BenchRow>& finished) {
    while (reported_ < rows_.size() && (rows_[reported_] || is_stopped_)) {
      std::optional<BenchRow>& row = rows_[reported_++];
      if (!row) continue;
      if (observer.finished) observer.finished(*row);
      finished.push_back(std::move(*row));
    }
  }

  const std::vector<BenchJob>& jobs_;
  const BenchOptions& options_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;        ///< the next job to take
  std::size_t reported_ = 0;    ///< jobs passed on
  std::size_t ended_ = 0;       ///< workers that have ended
  std::exception_ptr failure_;  ///< of a worker
  bool is_stopped_ = false;
  std::vector<std::optional<BenchRow>> rows_;
  std::vector<std::optional<Watched>> watched_;  ///< one a worker; empty between runs
};

}  // namespace

std::vector<BenchRow> run_jobs(const std::vector<BenchJob>& jobs, const BenchOptions& options,
                               const BenchObserver& observer) {
  return Pool(jobs, options).run(observer);
}

}  // namespace foldless
