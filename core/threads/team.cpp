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

Team::Share::Share() : ticket(kClosed) {}

Team::Team(int threads) : size_(std::max(1, threads)), shares_(static_cast<std::size_t>(size_)) {}

void Team::start_helpers() {
  const WithoutSignals without;
  try {
    helpers_.reserve(static_cast<std::size_t>(size_ - 1));
    for (int thread = 1; thread < size_; ++thread)
      helpers_.emplace_back([this, thread] { help(thread); });
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
  const std::uint64_t number = opened_.load(std::memory_order_relaxed) + 1;
  count_.store(count, std::memory_order_relaxed);
  done_by_helpers_.store(0, std::memory_order_relaxed);
  for (int thread = 0; thread < size_; ++thread)
    shares_[static_cast<std::size_t>(thread)].ticket.store(number << 32 | first_of(thread),
                                                           std::memory_order_release);
  opened_.store(number, std::memory_order_release);
  opened_.notify_all();
}

// A helper that is late must not take the next job's count for this one's.
void Team::close() {
  for (Share& share : shares_) share.ticket.fetch_or(kClosed, std::memory_order_relaxed);
}

void Team::run_job(int count, Job job) {
  const WithTeam none(nullptr);
  if (count > 1 && helpers_.empty() && size_ > 1) start_helpers();
  if (helpers_.empty() || count < 2) {
    for (int i = 0; i < count; ++i) job.call(job.task, i);
    return;
  }
  job_ = job;
  open(count);
  const int by_helpers = count - run_tasks(0);
  for (int looks = 0; done_by_helpers_.load(std::memory_order_acquire) < by_helpers; ++looks)
    looks < kLooksBeforeSleep ? rest() : std::this_thread::yield();
  close();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

std::uint64_t Team::first_of(int thread) const {
  const auto count = static_cast<std::uint64_t>(count_.load(std::memory_order_relaxed));
  return count * static_cast<std::uint64_t>(thread) / static_cast<std::uint64_t>(size_);
}

std::optional<int> Team::next_of(int thread) {
  std::atomic<std::uint64_t>& next = shares_[static_cast<std::size_t>(thread)].ticket;
  std::uint64_t ticket = next.load(std::memory_order_acquire);
  do {
    if (task_of(ticket) >= first_of(thread + 1)) return std::nullopt;
  } while (!next.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                       std::memory_order_acquire));
  return static_cast<int>(task_of(ticket));
}

int Team::run_tasks(int thread) {
  int done = 0;
  for (int k = 0; k < size_; ++k)
    while (const std::optional<int> task = next_of((thread + k) % size_)) {
      try {
        job_.call(job_.task, *task);
      } catch (...) {
        const std::lock_guard lock(error_guard_);
        error_ = std::current_exception();
      }
      ++done;
    }
  return done;
}

std::uint64_t Team::wait_for_work(std::uint64_t seen) const {
  for (int looks = 0; looks < kLooksBeforeSleep; ++looks) {
    const std::uint64_t opened = opened_.load(std::memory_order_acquire);
    if (opened != seen) return opened;
    rest();
  }
  opened_.wait(seen, std::memory_order_acquire);
  return opened_.load(std::memory_order_acquire);
}

void Team::help(int thread) {
  for (std::uint64_t seen = 0; !is_over_;) {
    seen = wait_for_work(seen);
    done_by_helpers_.fetch_add(run_tasks(thread), std::memory_order_acq_rel);
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
