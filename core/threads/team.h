// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

namespace foldless {

/// Threads that work on one thing together: the one that asks for it, and helpers. Each begins with
/// its share of the tasks, the i-th of as many parts as there are threads, so that it meets what it
/// has in its cache from the job before; then it takes tasks of others. A helper that has had
/// nothing to do for some microseconds sleeps; one that has not woken up yet is not waited for. One
/// thread at a time may ask.
class Team {
 public:
  /// Of threads − 1 helpers, which start with the first job of more than one task, fewer where the
  /// system gives no more; they take no signals.
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Threads, with the one that asks.
  int size() const { return size_; }

  /// Calls task(i) once for every 0 ≤ i < count, on any thread and in any order, and returns when
  /// all have returned. Throws what one of them threw.
  template <class Task>
  void run(int count, const Task& task) {
    run_job(count, {[](const void* of, int i) { (*static_cast<const Task*>(of))(i); }, &task});
  }

 private:
  struct Job {
    void (*call)(const void* task, int i);
    const void* task;
  };

  void run_job(int count, Job job);
  void start_helpers();
  void open(int count);
  void close();
  /// The first task of a thread's share; for the number of threads, how many tasks there are.
  std::uint64_t first_of(int thread) const;
  /// The next task of that share; nothing when all are taken.
  std::optional<int> next_of(int thread);
  /// Runs tasks of the open job, those of the thread's share first, until none is left; how many.
  int run_tasks(int thread);
  void help(int thread);
  /// The number of jobs that were opened, when it is another than `seen`.
  std::uint64_t wait_for_work(std::uint64_t seen) const;

  /// On a cache line of its own.
  struct alignas(64) Share {
    Share();
    /// The number of the job in the upper half, of the next task in the lower.
    std::atomic<std::uint64_t> ticket;
  };

  int size_;
  std::vector<std::thread> helpers_;
  std::vector<Share> shares_;  ///< by thread; the one that asks is the first
  std::atomic<std::uint64_t> opened_ = 0;
  std::atomic<int> count_ = 0, done_by_helpers_ = 0;
  std::atomic<bool> is_over_ = false;
  Job job_{};  ///< written while no job is open
  std::mutex error_guard_;
  std::exception_ptr error_;
};

/// Cores that this process may use, at least 1.
int cores();

/// While it lives, in_parallel() on this thread asks `team`; null, or one without helpers: nobody.
class WithTeam {
 public:
  explicit WithTeam(Team* team);
  ~WithTeam();
  WithTeam(const WithTeam&) = delete;
  WithTeam& operator=(const WithTeam&) = delete;

 private:
  Team* before_;
};

/// The team that in_parallel() asks on this thread; null where there is none. Tasks of a team have
/// none.
Team* present_team();

/// Calls task(i) once for every 0 ≤ i < count, by the team of this thread or, without one, in
/// order.
template <class Task>
void in_parallel(int count, const Task& task) {
  Team* team = present_team();
  if (team && count > 1) return team->run(count, task);
  for (int i = 0; i < count; ++i) task(i);
}

/// Calls task(begin, end) for ranges that make up 0 … count, each of `grain` but the last.
template <class Task>
void in_ranges(std::ptrdiff_t count, std::ptrdiff_t grain, const Task& task) {
  if (count <= grain || !present_team()) {
    if (count > 0) task(std::ptrdiff_t{0}, count);
    return;
  }
  in_parallel(static_cast<int>((count + grain - 1) / grain), [&](int i) {
    const std::ptrdiff_t begin = i * grain;
    task(begin, begin + grain < count ? begin + grain : count);
  });
}

/// Calls visit(i) once for every 0 ≤ i < count, `grain` of them in a task.
template <class Visit>
void each_in_ranges(std::ptrdiff_t count, std::ptrdiff_t grain, const Visit& visit) {
  in_ranges(count, grain, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t i = begin; i < end; ++i) visit(i);
  });
}

}  // namespace foldless
