// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/race_lane.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

/// Four lanes remember as much as one solver of the editor. [bytes]
constexpr std::size_t kTimelineBytes = std::size_t{64} << 20;

std::shared_ptr<const Snapshot> with_handles(const Document& document) {
  auto pose = std::make_shared<Snapshot>(*document.pose);
  pose->handles = document.handles;
  return pose;
}

}  // namespace

RaceLane::RaceLane(RaceEntry entry, const Document& start, std::function<void()> wake)
    : entry_(std::move(entry)),
      start_(start),
      shown_(with_handles(start)),
      proof_(proof_of(*shown_)),
      worker_(std::move(wake), {.timeline_bytes = kTimelineBytes, .start = start_method}) {
  start_.energy = entry_.energy;
  Problem problem = problem_of(start_);
  problem.parameters = entry_.parameters;
  worker_.load(std::move(problem));
}

void RaceLane::step_from(std::size_t tick) {
  if (records_.size() == tick && !has_ended()) worker_.step();
}

bool RaceLane::poll() {
  bool is_new = false;
  const WorkerStatus status = worker_.status();
  for (const TimelineEntry& entry : worker_.timeline(records_.size()).entries) {
    records_.push_back(entry.record);
    is_new = true;
  }
  if (status.is_current && status != status_) {
    status_ = status;
    is_new = true;
  }
  return is_new;
}

void RaceLane::show(std::size_t tick) {
  tick = std::min(tick, records_.size());
  if (tick == shown_tick_) return;
  shown_tick_ = tick;
  shown_ = tick == 0 ? with_handles(start_) : snapshot_after(tick);
  proof_ = proof_of(*shown_);
}

std::shared_ptr<const Snapshot> RaceLane::snapshot_after(std::size_t tick) const {
  for (const TimelineEntry& entry : worker_.timeline(tick - 1).entries)
    if (entry.snapshot) return entry.snapshot;
  return worker_.latest();
}

bool RaceLane::has_ended() const {
  return status_.state == WorkerState::finished || !status_.error.empty();
}

const Iteration* RaceLane::record() const {
  return shown_tick_ == 0 ? nullptr : &records_[shown_tick_ - 1];
}

bool RaceLane::is_at_targets() const {
  Document document = start_;
  document.pose = shown_;
  return foldless::is_at_targets(document);
}

std::string RaceLane::words() const {
  if (!error().empty()) return error();
  if (!is_at_end()) return "Iteration " + std::to_string(shown_tick_);
  const std::string after = " after " + std::to_string(shown_tick_);
  if (proof_.folds()) return "Folded" + after;
  if (is_at_targets()) return "Converged" + after;
  if (outcome() == Outcome::infeasible) return "Infeasible" + after;
  if (outcome() == Outcome::iteration_limit) return "Out of iterations" + after;
  return "Blocked" + after;
}

}  // namespace foldless
