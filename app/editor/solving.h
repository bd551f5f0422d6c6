// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/document.h"
#include "core/run/worker.h"

namespace foldless {

/// What the solver does for a document.
enum class SolvingState {
  held,     ///< nothing was sent: the document stays as it is until it is edited or run
  running,  ///< iterating, or about to
  paused,   ///< the user wants to see every step
  stopped,  ///< ended by the user
  finished  ///< ended by itself
};

/// The editor's side of the worker: remembers what was sent and whether the user paused, and knows
/// which snapshots are still of interest.
class Solving {
 public:
  explicit Solving(std::function<void()> wake);

  /// Solves a document that has another mesh or other handles than before, unless paused; from
  /// begin() on, so that targets which move in the same frame are not too late for the first step.
  void start(const Document& document);
  void begin();
  /// Stops, so that a document stays exactly as it is until the next call of another function.
  void hold();
  /// New targets of the same handles.
  void move_targets(const Document& document);
  /// New energy or parameters for the same mesh.
  void set_parameters(const Document& document);
  /// Pauses; goes on when paused, stopped, or held with something left to do.
  void toggle_pause(const Document& document);
  void pause();
  /// One iteration, then pause.
  void step(const Document& document);
  void stop();
  /// Iterations a second; nothing: as fast as it goes.
  void set_pace(std::optional<double> pace);
  /// The next iteration will be the first of the timeline.
  void clear_timeline();

  /// Takes what is new. Returns whether anything is.
  bool poll();

  SolvingState state() const;
  bool is_running() const { return state() == SolvingState::running; }
  /// The run has come to its end by itself, paused or not.
  bool has_ended() const;
  /// Edits do not end the pause.
  bool is_paused() const { return paused_; }
  /// The end of the run, if it has ended.
  Standing standing() const { return {status_.outcome, status_.satisfied, status_.verdict}; }
  /// One sentence when the run could not go on, else empty.
  const std::string& error() const { return status_.error; }

  /// The newest mesh that iterations of the present problem have made, or null.
  const std::shared_ptr<const Snapshot>& newest() const { return newest_; }
  /// Every iteration since the last edit.
  const std::vector<Iteration>& iterations() const { return iterations_; }
  /// The mesh after an iteration; where that was let go to save memory, the next that was kept;
  /// null when there is none.
  std::shared_ptr<const Snapshot> snapshot_of(std::size_t iteration) const;

 private:
  void load(const Document& document);
  void go_on(const Document& document);
  bool poll_timeline();

  Worker worker_;
  bool loaded_ = false;  ///< the worker's problem is the document's
  bool paused_ = false;
  bool stopped_ = false;
  bool begins_ = false;  ///< with begin()
  std::uint64_t generation_ = 0;
  std::uint64_t epoch_ = 0;
  WorkerStatus status_;
  std::shared_ptr<const Snapshot> newest_;
  std::vector<Iteration> iterations_;
};

}  // namespace foldless
