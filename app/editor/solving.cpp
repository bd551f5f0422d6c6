// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/solving.h"

#include <utility>

namespace foldless {
namespace {

Points targets_of(const Document& document) {
  Points targets(2, static_cast<Eigen::Index>(document.handles.size()));
  for (Eigen::Index k = 0; k < targets.cols(); ++k)
    targets.col(k) = document.handles[static_cast<std::size_t>(k)].target;
  return targets;
}

std::vector<double> angles_of(const Document& document) {
  std::vector<double> angles;
  for (const Handle& handle : document.handles)
    angles.push_back(handle.turn.value_or(Turn{}).angle);
  return angles;
}

}  // namespace

Solving::Solving(std::function<void()> wake) : worker_(std::move(wake)) {}

void Solving::start(const Document& document) {
  if (document.is_empty() || document.handles.empty()) return hold();
  load(document);
  begins_ = !paused_;
}

void Solving::begin() {
  if (std::exchange(begins_, false)) worker_.set_mode(WorkerMode::running);
}

void Solving::hold() {
  worker_.set_mode(WorkerMode::idle);
  begins_ = false;
  loaded_ = false;
  stopped_ = false;
  newest_ = nullptr;
  iterations_.clear();
}

void Solving::load(const Document& document) {
  // A pause first, so that no iteration slips in before the state is known.
  worker_.set_mode(WorkerMode::paused);
  generation_ = worker_.load(problem_of(document));
  loaded_ = true;
  stopped_ = false;
  newest_ = nullptr;
  iterations_.clear();
  status_ = {WorkerState::running, generation_, std::nullopt, {}, false, {}};
}

void Solving::move_targets(const Document& document) {
  if (!loaded_) return start(document);
  worker_.set_targets(targets_of(document), angles_of(document));
  begins_ = false;
  stopped_ = false;
  status_.state = WorkerState::running;
  if (!paused_) worker_.set_mode(WorkerMode::running);
}

void Solving::set_parameters(const Document& document) {
  if (!loaded_) return start(document);
  worker_.set_parameters(document.energy, document.parameters);
  stopped_ = false;
  status_.state = WorkerState::running;
  if (!paused_) worker_.set_mode(WorkerMode::running);
}

void Solving::toggle_pause(const Document& document) {
  const bool goes_on = state() == SolvingState::paused || state() == SolvingState::stopped ||
                       (state() == SolvingState::held && !is_at_targets(document));
  if (!goes_on) return pause();
  paused_ = false;
  go_on(document);
}

void Solving::go_on(const Document& document) {
  if (!loaded_) return start(document);
  stopped_ = false;
  status_.state = WorkerState::running;
  worker_.set_mode(WorkerMode::running);
}

void Solving::pause() {
  paused_ = true;
  begins_ = false;
  worker_.set_mode(WorkerMode::paused);
}

void Solving::step(const Document& document) {
  if (document.is_empty() || document.handles.empty()) return;
  pause();
  if (!loaded_) load(document);
  stopped_ = false;
  worker_.step();
}

void Solving::stop() {
  worker_.set_mode(WorkerMode::idle);
  begins_ = false;
  paused_ = false;
  stopped_ = loaded_;
}

void Solving::set_pace(std::optional<double> pace) { worker_.set_pace(pace); }

void Solving::clear_timeline() {
  worker_.clear_timeline();
  iterations_.clear();
}

bool Solving::poll() {
  if (!loaded_) return false;
  const WorkerStatus status = worker_.status();
  if (status.generation != generation_) return false;
  bool is_new = poll_timeline();
  // What waits to be taken up decides what the worker does next: see load() and its like.
  if (status.is_current && status != status_) {
    status_ = status;
    is_new = true;
  }
  const auto latest = worker_.latest();
  // The first snapshot of a problem is its own mesh, which the document has already.
  if (latest && latest->generation == generation_ && latest->iteration && latest != newest_) {
    newest_ = latest;
    is_new = true;
  }
  return is_new;
}

bool Solving::poll_timeline() {
  TimelinePart part = worker_.timeline(iterations_.size());
  bool is_new = false;
  if (part.epoch != epoch_) {
    is_new = !iterations_.empty();
    if (is_new) part = worker_.timeline();
    iterations_.clear();
    epoch_ = part.epoch;
  }
  for (const TimelineEntry& entry : part.entries) {
    iterations_.push_back(entry.record);
    is_new = true;
  }
  return is_new;
}

SolvingState Solving::state() const {
  if (paused_) return SolvingState::paused;
  if (!loaded_) return SolvingState::held;
  if (stopped_) return SolvingState::stopped;
  return has_ended() ? SolvingState::finished : SolvingState::running;
}

bool Solving::has_ended() const {
  return loaded_ && (status_.state == WorkerState::finished || !status_.error.empty());
}

std::shared_ptr<const Snapshot> Solving::snapshot_of(std::size_t iteration) const {
  for (const TimelineEntry& entry : worker_.timeline(iteration).entries)
    if (entry.snapshot && entry.snapshot->generation == generation_) return entry.snapshot;
  return nullptr;
}

}  // namespace foldless
