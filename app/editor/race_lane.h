// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/proof.h"
#include "app/editor/race_setup.h"
#include "core/run/worker.h"

namespace foldless {

/// One lane of a race: a solver of its own and everything that it has done. A tick is a number of
/// iterations: 0 is the start.
class RaceLane {
 public:
  RaceLane(RaceEntry entry, const Document& start, std::function<void()> wake);

  void run() { worker_.set_mode(WorkerMode::running); }
  void pause() { worker_.set_mode(WorkerMode::paused); }
  /// One iteration, when the lane stands at `tick` and has not ended.
  void step_from(std::size_t tick);
  /// Takes what is new; returns whether anything is.
  bool poll();
  /// Moves to the state after `tick` iterations, or to the last one when it has ended before.
  void show(std::size_t tick);

  const std::string& title() const { return entry_.title; }
  /// The part of the title that other lanes do not have.
  const std::string& short_title() const { return entry_.short_title; }
  const Parameters& parameters() const { return entry_.parameters; }
  const Density& energy() const { return *entry_.energy; }
  /// Every iteration so far.
  const std::vector<Iteration>& records() const { return records_; }
  bool has_ended() const;
  /// How it ended; nothing before that, or when it failed.
  std::optional<Outcome> outcome() const { return status_.outcome; }
  /// One sentence of the method on that end; may be empty.
  const std::string& verdict() const { return status_.verdict; }
  /// One sentence when the lane could not go on, else empty.
  const std::string& error() const { return status_.error; }

  // Of the state that is shown.

  const std::shared_ptr<const Snapshot>& shown() const { return shown_; }
  const Proof& proof() const { return proof_; }
  /// The record of the last iteration shown, or null at the start.
  const Iteration* record() const;
  /// True when the lane has ended, and its end is what is shown.
  bool is_at_end() const { return has_ended() && shown_tick_ >= records_.size(); }
  /// Every handle that is not soft is at its target.
  bool is_at_targets() const;
  /// "Iteration 12", or how it ended.
  std::string words() const;

 private:
  std::shared_ptr<const Snapshot> snapshot_after(std::size_t tick) const;

  RaceEntry entry_;
  Document start_;
  std::vector<Iteration> records_;
  WorkerStatus status_;
  std::size_t shown_tick_ = 0;
  std::shared_ptr<const Snapshot> shown_;
  Proof proof_;
  Worker worker_;  ///< last, so that its thread ends first
};

}  // namespace foldless
