// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/document.h"
#include "app/editor/history.h"
#include "app/editor/messages.h"
#include "app/editor/proof.h"
#include "app/editor/selection.h"
#include "app/editor/solving.h"
#include "app/editor/target_tolerance.h"
#include "core/depth/paint_order.h"

namespace foldless {

/// What an edit changes, as far as the solver is concerned.
enum class Change {
  appearance,  ///< nothing that it sees
  targets,     ///< targets of the same handles
  parameters,  ///< energy, method or numbers
  mesh         ///< the mesh, or which handles there are
};

/// An earlier iteration, or a frame of the animation, that is looked at in place of the newest
/// state.
struct LookBack {
  std::optional<std::size_t> iteration;  ///< of Solving::iterations(); absent: a frame
  std::shared_ptr<const Snapshot> pose;
};

/// The document in work: its history, what of it is selected, the solver behind it and the mesh
/// that it shows. An edit is begin_edit(), apply() as often as it changes, commit() or
/// abandon_edit().
class Draft {
 public:
  /// Keeps a reference. `wake` is called on the solver's thread when update() has news.
  Draft(Messages& messages, std::function<void()> wake, std::size_t history_bytes);

  const Document& document() const { return document_; }
  const History& history() const { return history_; }
  Selection& selection() { return selection_; }
  const Selection& selection() const { return selection_; }
  Solving& solving() { return solving_; }
  const Solving& solving() const { return solving_; }

  /// The mesh on screen, or null when nothing is open: the newest state, or the iteration that is
  /// looked at. Its handles have the newest targets.
  const std::shared_ptr<const Snapshot>& shown() const { return shown_; }
  /// Of the mesh on screen.
  const Proof& proof() const { return proof_; }
  /// target_tolerance() of the document.
  double target_tolerance() const { return tolerance_.of(document_); }
  /// For picking: which sheet of the mesh on screen lies in front.
  PaintOrder& paint_order() { return paint_order_; }
  /// The solver's newest map folds: the document has kept the last that does not.
  bool is_ahead_of_document() const { return folded_ != nullptr; }

  /// Sends the newest targets to the solver and takes its newest state.
  void update();

  // Edits.

  /// Called before an edit that no gesture makes, to cancel the gesture that is under way; returns
  /// whether there was one.
  void on_interrupt(std::function<bool()> interrupt) { interrupt_ = std::move(interrupt); }
  bool interrupt() { return interrupt_ && interrupt_(); }

  /// Called with the document before an edit and the one that the edit has made, which it may
  /// complete before that becomes an undo step.
  using Completion = std::function<void(const Document&, Document&)>;
  void on_commit(Completion complete) { complete_ = std::move(complete); }

  bool is_editing() const { return edit_.has_value(); }
  /// The document is about to change: what is on screen becomes the newest state.
  void begin_edit();
  /// The document as the edit makes it so far; the solver follows.
  void apply(Document document, Change change);
  /// The document that the edit makes, to be shown as it is, without the solver.
  void replace(const Document& document);
  /// Ends what begin_edit() began with one undo step.
  void commit(std::string label);
  /// Ends it with everything as it was.
  void abandon_edit();
  /// A whole edit. Where it leaves the pose as it was, and an earlier iteration is looked at, it
  /// goes on from that one.
  void edit(std::string label, Document document, Change change);
  /// A whole edit that is one step with those of the same label just before it.
  void edit_again(const std::string& label, Document document, Change change);
  /// Brings the current step up to date; the next edit makes a step of its own.
  void seal();

  void undo();
  void redo();
  void jump_to_step(std::size_t index);  ///< of history().steps()
  /// Another document, with a history and a selection of its own. Where memory runs short before
  /// it is there all stays as it was.
  void install(Document document, std::string label);

  // Earlier iterations.

  const std::optional<LookBack>& look_back() const { return look_back_; }
  void look_at(LookBack iteration);
  void look_at_newest();
  /// What is looked at becomes the newest state, without an undo step; a map that folds does not.
  void take_over_look_back();

 private:
  struct Edit {
    Document before;
    bool was_solving = false;
  };
  struct LastChange {
    std::string label;
    double time = 0;
  };

  const std::shared_ptr<const Snapshot>& pose_on_screen() const;
  void take_newest();
  void show_document();
  void refresh_shown();

  Messages& messages_;
  Document document_;
  History history_;
  Selection selection_;
  Solving solving_;
  std::function<bool()> interrupt_;
  Completion complete_;
  std::optional<Edit> edit_;
  std::optional<LastChange> last_change_;  ///< by edit_again()
  bool targets_moved_ = false;             ///< since the solver was told

  std::shared_ptr<const Snapshot> shown_;
  std::shared_ptr<const Snapshot> taken_;   ///< the solver's snapshot that the document has
  std::shared_ptr<const Snapshot> folded_;  ///< what the solver shows but no document may keep
  std::shared_ptr<const Snapshot> proved_;  ///< the pose that proof_ is about
  std::optional<LookBack> look_back_;
  Proof proof_;
  mutable TargetTolerance tolerance_;  ///< keeps what it found
  PaintOrder paint_order_;
};

}  // namespace foldless
