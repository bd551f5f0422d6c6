// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/document.h"

namespace foldless {

/// One state that can be gone back to.
struct HistoryStep {
  std::uint64_t id = 0;  ///< unique in a history
  std::string label;     ///< what led here, for the history panel
  Document document;
};

/// Undo and redo as a list of whole documents with shared structure. The step that is shown is
/// brought up to date with refresh() before it is left, so that going back and forth restores
/// meshes exactly, whatever was flipped or split in between.
class History {
 public:
  /// Steps beyond `memory_cap` bytes are forgotten, oldest first, but never the newest 100.
  explicit History(std::size_t memory_cap = std::size_t{512} << 20);

  /// Starts anew with one step. Where memory runs short all stays as it was.
  void reset(std::string label, Document document);
  /// Adds a step after the current one and forgets what was undone.
  void push(std::string label, Document document);
  /// Brings the current step up to date.
  void refresh(Document document);

  bool can_undo() const { return current_ > 0; }
  bool can_redo() const { return current_ + 1 < steps_.size(); }
  /// Moves to another step, which becomes the current one. Precondition: index < steps().size().
  const Document& jump(std::size_t index);

  /// Oldest first; never empty.
  const std::vector<HistoryStep>& steps() const { return steps_; }
  std::size_t current() const { return current_; }
  std::uint64_t current_id() const { return steps_[current_].id; }
  /// What the steps hold, shared parts counted once. [bytes]
  std::size_t bytes() const;

 private:
  void trim();

  std::size_t memory_cap_;
  std::vector<HistoryStep> steps_;
  std::size_t current_ = 0;
  std::uint64_t next_id_ = 1;
};

}  // namespace foldless
