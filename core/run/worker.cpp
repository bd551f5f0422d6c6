// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/worker.h"

#include <exception>
#include <utility>

#include "core/exception_words.h"
#include "core/run/thread_priority.h"
#include "core/threads/team.h"

namespace foldless {

Worker::Worker(std::function<void()> wake, WorkerOptions options)
    : wake_(std::move(wake)),
      timeline_(options.timeline_bytes),
      threads_(options.threads),
      run_(std::move(options.start)),
      thread_([this](const std::stop_token& stopping) { work(stopping); }) {}

Worker::~Worker() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  mailbox_.cancel_iteration();
}

template <typename Change>
void Worker::post(Mailbox::Cancels cancels, const Change& change) {
  {
    std::lock_guard lock(mutex_);
    mailbox_.post(cancels, change);
    status_.is_current = false;
  }
  changed_.notify_one();
}

std::uint64_t Worker::load(Problem problem) {
  std::uint64_t generation = 0;
  post(Mailbox::Cancels::always, [&](Inbox& inbox) {
    generation = mailbox_.next_generation();
    inbox.load = std::make_unique<const Inbox::Load>(std::move(problem), generation);
    inbox.settings.reset();
    inbox.targets.reset();
    timeline_.clear();
  });
  return generation;
}

void Worker::set_targets(Points targets, std::vector<double> angles) {
  post(Mailbox::Cancels::once, [&](Inbox& inbox) {
    inbox.targets = Inbox::Targets{std::move(targets), std::move(angles)};
  });
}

void Worker::set_parameters(const Density* energy, Parameters parameters) {
  post(Mailbox::Cancels::once, [&](Inbox& inbox) {
    inbox.settings = Inbox::Settings{energy, std::move(parameters)};
  });
}

void Worker::set_mode(WorkerMode mode) {
  const bool ends = mode == WorkerMode::idle;
  post(ends ? Mailbox::Cancels::always : Mailbox::Cancels::never,
       [mode](Inbox& inbox) { inbox.set_mode(mode); });
}

void Worker::step() {
  post(Mailbox::Cancels::never, [](Inbox& inbox) {
    inbox.set_mode(WorkerMode::paused);
    inbox.step = true;
  });
}

void Worker::set_pace(std::optional<double> iterations_per_second) {
  post(Mailbox::Cancels::never, [&](Inbox& inbox) { inbox.pace = iterations_per_second; });
}

WorkerStatus Worker::status() const {
  std::lock_guard lock(mutex_);
  return status_;
}

TimelinePart Worker::timeline(std::size_t first) const {
  std::lock_guard lock(mutex_);
  return {timeline_.epoch(), timeline_.from(first)};
}

void Worker::clear_timeline() {
  std::lock_guard lock(mutex_);
  timeline_.clear();
}

void Worker::work(const std::stop_token& stopping) {
  give_way_to_the_window();
  Team team(threads_);
  const WithTeam with(&team);
  while (true) {
    try {
      if (!take_turn(stopping)) return;
      publish_status();
    } catch (const std::exception& failure) {
      run_.end_because(words_of_exception(failure));
      publish_failure();
    }
  }
}

bool Worker::take_turn(const std::stop_token& stopping) {
  Inbox messages;
  std::stop_token token;
  std::uint64_t epoch = 0;
  {
    std::unique_lock lock(mutex_);
    wait_for_something_to_do(lock, stopping);
    if (stopping.stop_requested()) return false;
    token = mailbox_.begin_iteration();  // needs memory: without it the messages wait
    messages = mailbox_.collect();
    epoch = timeline_.epoch();
  }
  if (messages.is_empty()) {
    iterate(token, epoch);
  } else {
    run_.apply(messages);
    if (run_.snapshot()) snapshots_.publish(run_.snapshot());
  }
  return true;
}

void Worker::wait_for_something_to_do(std::unique_lock<std::mutex>& lock,
                                      const std::stop_token& stopping) {
  const auto has_messages = [this] { return !mailbox_.is_empty(); };
  if (!run_.can_iterate())
    changed_.wait(lock, stopping, has_messages);
  else if (const auto start = run_.next_start())
    changed_.wait_until(lock, stopping, *start, has_messages);
}

void Worker::iterate(const std::stop_token& token, std::uint64_t epoch) {
  const std::shared_ptr<const Snapshot> before = run_.snapshot();
  const PacedRun::Step step = run_.iterate(token);

  std::lock_guard lock(mutex_);
  mailbox_.end_iteration(step.was_cancelled);
  // A load that waits has made this iteration the past, a cleared timeline its record.
  if (!step.iteration || mailbox_.has_load()) return;
  const bool is_published = run_.snapshot() != before;
  if (is_published) snapshots_.publish(run_.snapshot());
  if (epoch == timeline_.epoch())
    timeline_.append(*step.iteration, is_published ? run_.snapshot() : nullptr);
}

void Worker::publish_status() {
  WorkerStatus status = run_.status();
  {
    std::lock_guard lock(mutex_);
    status.is_current = mailbox_.is_empty();
    status_ = std::move(status);
  }
  if (wake_) wake_();
}

void Worker::publish_failure() {
  try {
    publish_status();
  } catch (const std::exception&) {
    return;  // no memory for that either: it is told with the next that is posted
  }
}

}  // namespace foldless
