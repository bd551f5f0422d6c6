// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/worker.h"

#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace foldless {
namespace {

/// Lets the window's thread, and the driver's threads where the processor draws, go first when the
/// cores are busy: frames are on time and the solver takes the rest. Without effect where refused.
void give_way_to_the_window() {
  constexpr id_t kThisThread = 0;
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, kThisThread, kNice);
}

}  // namespace

Worker::Worker(std::function<void()> wake, WorkerOptions options)
    : wake_(std::move(wake)),
      options_(std::move(options)),
      timeline_(options_.timeline_bytes),
      thread_([this](const std::stop_token& stopping) { work(stopping); }) {}

Worker::~Worker() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  iteration_stop_.request_stop();
}

template <typename Change>
void Worker::post(Cancels cancels, const Change& change) {
  {
    std::lock_guard lock(mutex_);
    change();
    status_.is_current = false;
    if (cancels == Cancels::always || (cancels == Cancels::once && !last_was_cancelled_))
      iteration_stop_.request_stop();
  }
  changed_.notify_one();
}

std::uint64_t Worker::load(Problem problem) {
  std::uint64_t generation = 0;
  post(Cancels::always, [&] {
    generation = ++last_generation_;
    inbox_.load = Inbox::Load{std::move(problem), generation};
    inbox_.settings.reset();
    inbox_.targets.reset();
    timeline_.clear();
  });
  return generation;
}

void Worker::set_targets(Points targets) {
  post(Cancels::once, [&] { inbox_.targets = std::move(targets); });
}

void Worker::set_parameters(const Density* energy, Parameters parameters) {
  post(Cancels::once, [&] { inbox_.settings = Inbox::Settings{energy, std::move(parameters)}; });
}

void Worker::run() {
  post(Cancels::never, [&] {
    inbox_.mode = WorkerMode::running;
    inbox_.step = false;
  });
}

void Worker::pause() {
  post(Cancels::never, [&] {
    inbox_.mode = WorkerMode::paused;
    inbox_.step = false;
  });
}

void Worker::step() {
  post(Cancels::never, [&] {
    inbox_.mode = WorkerMode::paused;
    inbox_.step = true;
  });
}

void Worker::stop() {
  post(Cancels::always, [&] {
    inbox_.mode = WorkerMode::idle;
    inbox_.step = false;
  });
}

void Worker::set_pace(std::optional<double> iterations_per_second) {
  post(Cancels::never, [&] { inbox_.pace = iterations_per_second; });
}

WorkerStatus Worker::status() const {
  std::lock_guard lock(mutex_);
  return status_;
}

std::vector<TimelineEntry> Worker::timeline(std::size_t first) const {
  std::lock_guard lock(mutex_);
  return timeline_.from(first);
}

std::uint64_t Worker::timeline_epoch() const {
  std::lock_guard lock(mutex_);
  return timeline_.epoch();
}

void Worker::clear_timeline() {
  std::lock_guard lock(mutex_);
  timeline_.clear();
}

void Worker::work(const std::stop_token& stopping) {
  give_way_to_the_window();
  while (true) {
    Inbox messages;
    std::stop_token token;
    std::uint64_t epoch = 0;
    {
      std::unique_lock lock(mutex_);
      wait_for_something_to_do(lock, stopping);
      if (stopping.stop_requested()) return;
      messages = std::exchange(inbox_, {});
      // A message that comes from here on finds the stop source of the iteration it may cancel.
      iteration_stop_ = std::stop_source();
      token = iteration_stop_.get_token();
      epoch = timeline_.epoch();
    }
    if (messages.is_empty())
      attempt([&] { iterate(token, epoch); });
    else
      attempt([&] { take(std::move(messages)); });
    publish_status();
  }
}

void Worker::wait_for_something_to_do(std::unique_lock<std::mutex>& lock,
                                      const std::stop_token& stopping) {
  const auto has_messages = [this] { return !inbox_.is_empty(); };
  if (!can_iterate())
    changed_.wait(lock, stopping, has_messages);
  else if (period_ && last_start_ && !step_)
    changed_.wait_until(lock, stopping, *last_start_ + *period_, has_messages);
}

bool Worker::can_iterate() const {
  return run_ && !run_->outcome() && (step_ || mode_ == WorkerMode::running);
}

template <typename Task>
void Worker::attempt(const Task& task) {
  try {
    task();
    return;
  } catch (const std::exception& failure) {
    error_ = failure.what();
  } catch (...) {
    error_ = "the solver failed for an unknown reason";
  }
  run_.reset();
}

void Worker::take(Inbox messages) {
  // The mode first: it holds whatever fails below.
  if (messages.mode) {
    mode_ = *messages.mode;
    step_ = messages.step;
  }
  if (messages.pace) {
    period_.reset();
    // An hour at most, so that the sum with a time point stays in range.
    if (*messages.pace)
      period_ = std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double>(std::min(1 / **messages.pace, 3600.0)));
  }
  if (messages.load) {
    run_.reset();
    error_.clear();
    generation_ = messages.load->generation;
    run_.emplace(messages.load->problem, generation_, options_.start);
  }
  if (run_ && messages.settings) {
    Problem problem = run_->resumed();
    problem.energy = messages.settings->energy;
    problem.parameters = messages.settings->parameters;
    run_.emplace(problem, generation_, options_.start);
  }
  if (run_ && messages.targets) run_->set_targets(*messages.targets);
  if (run_) snapshots_.publish(run_->snapshot());
  if (!can_iterate()) step_ = false;
}

void Worker::iterate(const std::stop_token& token, std::uint64_t epoch) {
  last_start_ = Clock::now();
  const std::shared_ptr<const Snapshot> before = run_->snapshot();
  const std::optional<Iteration> iteration = run_->step(token);
  const bool was_cancelled = !iteration && !run_->outcome() && token.stop_requested();
  if (!was_cancelled) step_ = false;

  std::lock_guard lock(mutex_);
  last_was_cancelled_ = was_cancelled;
  // A load that waits has made this iteration the past, a cleared timeline its record.
  if (!iteration || inbox_.load) return;
  const bool is_published = run_->snapshot() != before;
  if (is_published) snapshots_.publish(run_->snapshot());
  if (epoch == timeline_.epoch())
    timeline_.append(*iteration, is_published ? run_->snapshot() : nullptr);
}

void Worker::publish_status() {
  WorkerStatus status;
  status.generation = generation_;
  status.error = error_;
  if (run_) {
    status.satisfied = run_->is_satisfied();
    if (mode_ != WorkerMode::idle) status.outcome = run_->outcome();
    if (status.outcome) status.verdict = run_->verdict();
    if (status.outcome)
      status.state = WorkerState::finished;
    else if (can_iterate())
      status.state = WorkerState::running;
    else if (mode_ == WorkerMode::paused)
      status.state = WorkerState::paused;
  }
  {
    std::lock_guard lock(mutex_);
    status.is_current = inbox_.is_empty();
    status_ = std::move(status);
  }
  if (wake_) wake_();
}

}  // namespace foldless
