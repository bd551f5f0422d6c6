// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/team.h"

#include <sched.h>
#include <signal.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

namespace foldless {
namespace {

thread_local Team* team_of_this_thread = nullptr;

constexpr std::uint64_t kClosed = std::numeric_limits<std::uint32_t>::max();
/// Some tens of microseconds: as long as there are between two things that one step does in
/// parallel.
constexpr int kLooksBeforeSleep = 2000;

std::uint64_t task_of(std::uint64_t ticket) { return ticket & kClosed; }

/// Lets the processor rest for some tens of cycles.
void rest() {
#ifdef __x86_64__
  __builtin_ia32_pause();
#endif
}

/// While it lives, threads that are started take no signals: those are for the ones that were
/// there.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

Team::Team(int threads) : size_(std::max(1, threads)), ticket_(kClosed) {}

void Team::start_helpers() {
  const WithoutSignals without;
  try {
    helpers_.reserve(static_cast<std::size_t>(size_ - 1));
    while (size() > static_cast<int>(helpers_.size()) + 1)
      helpers_.emplace_back([this] { help(); });
  } catch (const std::exception&) {
    size_ = static_cast<int>(helpers_.size()) + 1;  // those that are there do the work
  }
}

Team::~Team() {
  is_over_ = true;
  open(0);
  for (std::thread& helper : helpers_) helper.join();
}

void Team::open(int count) {
  const std::uint64_t number = (ticket_.load(std::memory_order_relaxed) >> 32) + 1;
  count_.store(count, std::memory_order_relaxed);
  done_.store(0, std::memory_order_relaxed);
  ticket_.store(number << 32, std::memory_order_release);
  ticket_.notify_all();
}

// A helper that is late must not take the next job's count for this one's.
void Team::close() { ticket_.fetch_or(kClosed, std::memory_order_relaxed); }

void Team::run_job(int count, Job job) {
  const WithTeam none(nullptr);
  if (count > 1 && helpers_.empty() && size_ > 1) start_helpers();
  if (helpers_.empty() || count < 2) {
    for (int i = 0; i < count; ++i) job.call(job.task, i);
    return;
  }
  job_ = job;
  open(count);
  while (run_next()) {
  }
  for (int looks = 0; done_.load(std::memory_order_acquire) < count; ++looks)
    looks < kLooksBeforeSleep ? rest() : std::this_thread::yield();
  close();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

bool Team::run_next() {
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  do {
    if (task_of(ticket) >= static_cast<std::uint64_t>(count_.load(std::memory_order_relaxed)))
      return false;
  } while (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                          std::memory_order_acquire));
  try {
    job_.call(job_.task, static_cast<int>(task_of(ticket)));
  } catch (...) {
    const std::lock_guard lock(error_guard_);
    error_ = std::current_exception();
  }
  done_.fetch_add(1, std::memory_order_acq_rel);
  return true;
}

std::uint64_t Team::wait_for_work(std::uint64_t seen) const {
  for (int looks = 0; looks < kLooksBeforeSleep; ++looks) {
    const std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    if (ticket != seen) return ticket;
    rest();
  }
  ticket_.wait(seen, std::memory_order_acquire);
  return ticket_.load(std::memory_order_acquire);
}

void Team::help() {
  std::uint64_t seen = kClosed;
  while (!is_over_) {
    while (run_next()) {
    }
    seen = wait_for_work(seen);
  }
}

int cores() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return std::max(1, CPU_COUNT(&set));
}

WithTeam::WithTeam(Team* team)
    : before_(std::exchange(team_of_this_thread, team && team->size() > 1 ? team : nullptr)) {}
WithTeam::~WithTeam() { team_of_this_thread = before_; }

Team* present_team() { return team_of_this_thread; }

}  // namespace foldless
