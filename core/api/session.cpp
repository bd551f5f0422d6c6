// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/session.h>

#include <mutex>
#include <stop_token>
#include <utility>

#include "core/api/arrays.h"
#include "core/api/parents.h"
#include "core/api/point_map.h"
#include "core/api/problem_of_arrays.h"
#include "core/run/stop_watch.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// What there is to know of a run, as others may read it while the run goes on.
struct Standing {
  std::shared_ptr<const Snapshot> snapshot;
  std::optional<Outcome> outcome;
  std::string verdict;
  bool is_reached = false;
  std::vector<Iteration> log;
};

}  // namespace

class Session::Impl {
 public:
  Impl(const Problem& problem, const SolveOptions& options)
      : input_(problem.mesh.triangles()),
        handles_(static_cast<Eigen::Index>(problem.handles.size())),
        time_limit_(options.time_limit),
        team_(options.threads),
        run_(problem, 0, starter_for(options)) {
    note(std::nullopt);
  }

  void set_targets(const PointsRef& targets);
  bool step();
  bool run();
  void cancel();
  Standing standing() const;
  std::shared_ptr<const Snapshot> snapshot() const;
  bool is_reached() const;
  bool has_ended() const;
  const Triangles& input() const { return input_; }

 private:
  void take_targets();
  bool take_step(const std::stop_token& token);
  void note(const std::optional<Iteration>& record);
  std::stop_token token() const;
  void note_end(bool is_time_over);

  const Triangles input_;
  const Eigen::Index handles_;
  const std::optional<double> time_limit_;

  std::mutex solving_;  ///< held by the one thread that steps
  Team team_;           ///< of that thread
  Run run_;             ///< of that thread

  mutable std::mutex telling_;  ///< held for moments; taken after the other
  Standing standing_;
  std::optional<Points> new_targets_;  ///< that no step has seen
  std::stop_source stop_;              ///< of the step or run under way, or the next one
};

void Session::Impl::set_targets(const PointsRef& targets) {
  check_points(targets, "targets", handles_, "handles");
  const std::scoped_lock lock(telling_);
  new_targets_ = points_of(targets);
}

void Session::Impl::take_targets() {
  std::optional<Points> targets;
  {
    const std::scoped_lock lock(telling_);
    targets = std::exchange(new_targets_, std::nullopt);
    if (targets) standing_.log.clear();
  }
  if (targets) run_.set_targets(*targets);
}

void Session::Impl::note(const std::optional<Iteration>& record) {
  std::string verdict = run_.verdict();
  const bool is_reached = run_.is_satisfied();
  const std::scoped_lock lock(telling_);
  standing_.snapshot = run_.snapshot();
  standing_.outcome = run_.outcome();
  standing_.verdict = std::move(verdict);
  standing_.is_reached = is_reached;
  if (record) standing_.log.push_back(*record);
}

bool Session::Impl::take_step(const std::stop_token& token) {
  if (token.stop_requested()) return false;
  const WithTeam with(&team_);
  take_targets();
  const std::optional<Iteration> record = run_.step(token);
  note(record);
  return record.has_value();
}

std::stop_token Session::Impl::token() const {
  const std::scoped_lock lock(telling_);
  return stop_.get_token();
}

/// A cancellation has done its work: later steps have a source of their own.
void Session::Impl::note_end(bool is_time_over) {
  const std::scoped_lock lock(telling_);
  const bool is_cancelled = stop_.stop_requested();
  if (is_cancelled) stop_ = std::stop_source();
  if (standing_.outcome) return;
  if (is_cancelled)
    standing_.outcome = Outcome::cancelled;
  else if (is_time_over)
    standing_.outcome = Outcome::time_limit;
}

bool Session::Impl::step() {
  const std::scoped_lock lock(solving_);
  const bool has_moved = take_step(token());
  note_end(false);
  return has_moved;
}

bool Session::Impl::run() {
  const std::scoped_lock lock(solving_);
  const std::stop_token cancelled = token();
  const StopWatch watch(
      {.time_limit = time_limit_, .is_interrupted = [&] { return cancelled.stop_requested(); }});
  bool goes_on = true;
  while (goes_on && !cancelled.stop_requested()) goes_on = take_step(watch.token());
  note_end(watch.is_time_over());
  return has_ended();
}

void Session::Impl::cancel() {
  const std::scoped_lock lock(telling_);
  stop_.request_stop();
}

Standing Session::Impl::standing() const {
  const std::scoped_lock lock(telling_);
  Standing standing = standing_;
  if (!new_targets_) return standing;
  standing.outcome.reset();
  standing.verdict.clear();
  standing.is_reached = false;
  return standing;
}

std::shared_ptr<const Snapshot> Session::Impl::snapshot() const {
  const std::scoped_lock lock(telling_);
  return standing_.snapshot;
}

bool Session::Impl::is_reached() const {
  const std::scoped_lock lock(telling_);
  return !new_targets_ && standing_.is_reached;
}

bool Session::Impl::has_ended() const {
  const std::scoped_lock lock(telling_);
  return !new_targets_ && standing_.outcome && *standing_.outcome != Outcome::cancelled &&
         *standing_.outcome != Outcome::time_limit;
}

Session::Session(const PointsRef& rest, const TrianglesRef& triangles,
                 const std::vector<int>& handles, const PointsRef& targets,
                 const SolveOptions& options)
    : impl_(std::make_unique<Impl>(problem_of_arrays(rest, triangles, handles, targets, options),
                                   options)) {}

Session::~Session() = default;
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;

void Session::set_targets(const PointsRef& targets) { impl_->set_targets(targets); }
bool Session::step() { return impl_->step(); }
bool Session::run() { return impl_->run(); }
void Session::cancel() { impl_->cancel(); }
bool Session::has_ended() const { return impl_->has_ended(); }
bool Session::is_reached() const { return impl_->is_reached(); }
PointMatrix Session::deformed() const { return rows_of(impl_->snapshot()->deformed); }

Result Session::result() const {
  Standing standing = impl_->standing();
  const Snapshot& snapshot = *standing.snapshot;
  Result result;
  result.rest = rows_of(*snapshot.rest);
  result.triangles = rows_of(*snapshot.triangles);
  result.deformed = rows_of(snapshot.deformed);
  result.parents = parents_of(snapshot, impl_->input());
  result.outcome = standing.outcome;
  result.verdict = std::move(standing.verdict);
  result.is_reached = standing.is_reached;
  result.log = std::move(standing.log);
  result.point_map = std::make_shared<const PointMap>(impl_->input(), standing.snapshot);
  return result;
}

}  // namespace foldless
