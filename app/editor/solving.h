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

/// The editor's side of the worker: remembers what was sent, whether the user paused, and which
/// snapshots are still of interest.
class Solving {
 public:
  explicit Solving(std::function<void()> wake);

  /// Nothing to solve any more.
  void clear();
  /// Solves a document, unless the user has paused.
  void start(const Document& document);
  /// Loads a document without solving: it stays exactly as it is until the next edit or run().
  void hold(const Document& document);
  /// New targets of the same handles.
  void move_targets(const Document& document);
  /// New energy or parameters for the same mesh.
  void set_parameters(const Document& document);

  void toggle_pause();
  void pause();
  void step();
  void stop();
  void set_pace(std::optional<double> pace);
  void clear_timeline();

  /// Takes what is new. Returns whether anything is.
  bool poll();
  /// The newest snapshot after an iteration of the present load, or null when there was none.
  const std::shared_ptr<const Snapshot>& newest() const { return newest_; }
  /// What the worker said last; absent while the document is held as it was restored.
  const std::optional<WorkerStatus>& status() const { return status_; }
  bool is_running() const;
  /// The user asked for the pause; edits do not end it.
  bool is_paused() const { return paused_; }

  /// Every iteration since the last edit.
  const std::vector<Iteration>& iterations() const { return iterations_; }
  /// The mesh after an iteration, or null when it was let go to save memory.
  std::shared_ptr<const Snapshot> snapshot_of(std::size_t iteration) const;

 private:
  Worker worker_;
  std::uint64_t generation_ = 0;
  std::uint64_t epoch_ = 0;
  bool is_loaded_ = false;
  bool paused_ = false;
  std::shared_ptr<const Snapshot> newest_;
  std::optional<WorkerStatus> status_;
  std::vector<Iteration> iterations_;
};

}  // namespace foldless
