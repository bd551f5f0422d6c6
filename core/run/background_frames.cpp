// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_frames.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/exception_words.h"
#include "core/run/thread_priority.h"

namespace foldless {
namespace {

bool is_same(const MeshPair& a, const MeshPair& b) {
  const auto& s = a.stiffness();
  const auto& t = b.stiffness();
  return a.triangles().cols() == b.triangles().cols() && a.triangles() == b.triangles() &&
         a.rest().cols() == b.rest().cols() && a.rest() == b.rest() &&
         a.deformed() == b.deformed() && (s == t || (s && t && *s == *t));
}

bool is_same_start(const Problem& a, const Problem& b) {
  return a.energy == b.energy && a.parameters == b.parameters && is_same(a.mesh, b.mesh);
}

std::vector<double> moments(const AnimationToSolve& wanted) {
  return moments_of(wanted.animation, wanted.animation.fps);
}

/// How many frames from the first on have the same handles.
std::size_t unchanged_frames(const AnimationToSolve& a, const AnimationToSolve& b) {
  const std::vector<double> frames = moments(a);
  const std::size_t count = std::min(frames.size(), moments(b).size());
  std::size_t same = 0;
  while (same < count && handles_at(a.animation, a.at_rest.handles, frames[same]) ==
                             handles_at(b.animation, b.at_rest.handles, frames[same]))
    ++same;
  return same;
}

/// Nothing at all would be solved in another way.
bool is_same_animation(const AnimationToSolve& a, const AnimationToSolve& b) {
  const Cycle &p = a.animation.cycle, &q = b.animation.cycle;
  if (!(p == q) || a.tolerance != b.tolerance) return false;
  if (unchanged_frames(a, b) < moments(a).size()) return false;
  return !p.loops || handles_at(a.animation, a.at_rest.handles, p.frames) ==
                         handles_at(b.animation, b.at_rest.handles, p.frames);
}

}  // namespace

BackgroundFrames::BackgroundFrames(std::function<void()> wake)
    : wake_(std::move(wake)),
      thread_([this](const std::stop_token& stopping) { work(stopping); }) {}

BackgroundFrames::~BackgroundFrames() {
  thread_.request_stop();
  std::lock_guard lock(mutex_);
  running_.request_stop();
}

void BackgroundFrames::solve(AnimationToSolve wanted) {
  {
    std::lock_guard lock(mutex_);
    const bool same_start = wanted_ && is_same_start(wanted_->at_rest, wanted.at_rest);
    if (same_start && is_same_animation(*wanted_, wanted)) return;
    const std::size_t kept = same_start ? unchanged_frames(*wanted_, wanted) : 0;
    first_round_.resize(std::min(kept, first_round_.size()));
    if (!same_start) before_ = std::make_shared<SolvedBefore>();
    done_.clear();
    error_.clear();
    round_ = 1;
    wanted_ = std::move(wanted);
    running_.request_stop();
  }
  changed_.notify_one();
}

void BackgroundFrames::clear() {
  std::lock_guard lock(mutex_);
  wanted_.reset();
  first_round_.clear();
  before_ = std::make_shared<SolvedBefore>();
  done_.clear();
  error_.clear();
  running_.request_stop();
}

void BackgroundFrames::hold(bool is_held) {
  {
    std::lock_guard lock(mutex_);
    if (std::exchange(is_held_, is_held) == is_held) return;
    if (is_held) running_.request_stop();
  }
  changed_.notify_one();
}

std::shared_ptr<const SolvedFrame> BackgroundFrames::frame(std::size_t index) const {
  std::lock_guard lock(mutex_);
  const auto& frames = done_.empty() ? first_round_ : done_;
  return index < frames.size() ? frames[index] : nullptr;
}

FramesStatus BackgroundFrames::status() const {
  std::lock_guard lock(mutex_);
  FramesStatus status;
  if (!wanted_) return status;
  status.count = moments(*wanted_).size();
  status.is_done = !done_.empty();
  status.round = status.is_done ? 1 : round_;
  const auto& frames = status.is_done ? done_ : first_round_;
  status.solved = frames.size();
  status.injective = static_cast<std::size_t>(std::ranges::count_if(frames, [](const auto& frame) {
    return frame->snapshot->is_valid() && frame->snapshot->overlapping_boundary_vertices == 0;
  }));
  if (status.is_done && wanted_->animation.cycle.loops) status.gap = gap_;
  status.error = error_;
  return status;
}

void BackgroundFrames::work(const std::stop_token& stopping) {
  give_way_to_the_window();
  const auto has_work = [this] { return wanted_ && done_.empty() && error_.empty() && !is_held_; };
  while (true) {
    std::stop_token token;
    try {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stopping, has_work);
      if (stopping.stop_requested()) return;
      Task task = begin_task();
      token = task.token;
      lock.unlock();
      solve_all(task);
    } catch (const std::exception& failure) {
      // What was cancelled meanwhile is about something that nobody wants any more.
      const std::lock_guard lock(mutex_);
      if (!token.stop_requested()) error_ = words_of_exception(failure);
    }
    if (wake_) wake_();
  }
}

BackgroundFrames::Task BackgroundFrames::begin_task() {
  Task task{Frames(wanted_->at_rest, wanted_->animation), {}, {}};
  task.wanted.moments = moments(*wanted_);
  task.wanted.tolerance = wanted_->tolerance;
  for (const auto& frame : first_round_) task.wanted.known.push_back(*frame);
  task.wanted.before = before_;
  round_ = 1;
  running_ = std::stop_source();
  task.token = running_.get_token();
  return task;
}

void BackgroundFrames::note_round(int round, const std::stop_token& token) {
  {
    const std::lock_guard lock(mutex_);
    if (token.stop_requested() || std::exchange(round_, round) == round) return;
  }
  if (wake_) wake_();
}

void BackgroundFrames::solve_all(Task& task) {
  task.wanted.first_round = [&](const SolvedFrame& frame) {
    {
      auto solved = std::make_shared<const SolvedFrame>(frame);
      const std::lock_guard lock(mutex_);
      if (task.token.stop_requested()) return;
      first_round_.push_back(std::move(solved));
    }
    if (wake_) wake_();
  };
  task.wanted.progress = [&](std::size_t, std::size_t, int round) {
    note_round(round, task.token);
  };
  const auto solved = solve_animation(task.frames, task.wanted, task.token);
  if (!solved) return;
  std::vector<std::shared_ptr<const SolvedFrame>> done;
  for (const SolvedFrame& frame : solved->frames)
    done.push_back(std::make_shared<const SolvedFrame>(frame));
  const std::lock_guard lock(mutex_);
  if (task.token.stop_requested()) return;
  done_ = std::move(done);
  gap_ = solved->gap;
}

}  // namespace foldless
