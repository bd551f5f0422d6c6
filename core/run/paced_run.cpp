// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/paced_run.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/exception_words.h"

namespace foldless {
namespace {

/// For how long a step that is to be watched stays on screen.
constexpr std::chrono::milliseconds kPicture(16);

}  // namespace

PacedRun::PacedRun(MethodStarter start) : start_(std::move(start)) {}

template <typename Task>
void PacedRun::end_where_it_throws(const Task& task) {
  try {
    task();
    return;
  } catch (const std::exception& failure) {
    end_because(words_of_exception(failure));
  } catch (...) {
    end_because("the solver failed for an unknown reason");
  }
}

void PacedRun::end_because(std::string words) {
  error_ = std::move(words);
  run_.reset();
}

void PacedRun::apply(const Inbox& messages) {
  if (messages.mode) {
    mode_ = *messages.mode;
    step_ = messages.step;
  }
  if (messages.pace) set_pace(*messages.pace);
  end_where_it_throws([&] { change_run(messages); });
  if (!can_iterate()) step_ = false;
}

void PacedRun::set_pace(std::optional<double> iterations_per_second) {
  period_.reset();
  // An hour at most, so that the sum with a time point stays in range.
  if (iterations_per_second)
    period_ = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(1 / *iterations_per_second, 3600.0)));
}

void PacedRun::change_run(const Inbox& messages) {
  if (messages.load) {
    run_.reset();
    error_.clear();
    generation_ = messages.load->generation;
    run_.emplace(messages.load->problem, generation_, start_);
  }
  if (run_ && messages.settings) {
    Problem problem = run_->resumed();
    problem.energy = messages.settings->energy;
    problem.parameters = messages.settings->parameters;
    run_.emplace(problem, generation_, start_);
  }
  if (run_ && messages.targets)
    run_->set_targets(messages.targets->positions, messages.targets->angles);
}

bool PacedRun::can_iterate() const {
  return run_ && !run_->outcome() && (step_ || mode_ == WorkerMode::running);
}

std::optional<PacedRun::Clock::time_point> PacedRun::next_start() const {
  if (!last_start_ || step_ || !(period_ || is_walking_)) return std::nullopt;
  const Clock::duration watched = is_walking_ ? kPicture : Clock::duration::zero();
  return *last_start_ + std::max(period_.value_or(watched), watched);
}

PacedRun::Step PacedRun::iterate(const std::stop_token& token) {
  last_start_ = Clock::now();
  is_walking_ = false;
  Step step;
  end_where_it_throws([&] {
    // Not assigned outright: GCC 12 lets step() write into `step` before it throws.
    if (const std::optional<Iteration> iteration = run_->step(token)) step.iteration = *iteration;
    is_walking_ = step.iteration && step.iteration->phase == Phase::walk;
    step.was_cancelled = !step.iteration && !run_->outcome() && token.stop_requested();
    if (!step.was_cancelled) step_ = false;
  });
  return step;
}

std::shared_ptr<const Snapshot> PacedRun::snapshot() const {
  return run_ ? run_->snapshot() : nullptr;
}

WorkerStatus PacedRun::status() const {
  WorkerStatus status;
  status.generation = generation_;
  status.error = error_;
  if (!run_) return status;
  status.satisfied = run_->is_satisfied();
  if (mode_ != WorkerMode::idle) status.outcome = run_->outcome();
  if (status.outcome) status.verdict = run_->verdict();
  if (status.outcome)
    status.state = WorkerState::finished;
  else if (can_iterate())
    status.state = WorkerState::running;
  else if (mode_ == WorkerMode::paused)
    status.state = WorkerState::paused;
  return status;
}

}  // namespace foldless
