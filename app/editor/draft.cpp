// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/draft.h"

#include <string_view>
#include <utility>

namespace foldless {
namespace {

/// Moves of one slider or key that follow each other this closely make one undo step. [s]
constexpr double kMergeSeconds = 1;

constexpr std::string_view kFoldedMapLeft =
    "The map on screen was folded; the edit goes on from the last valid one";

}  // namespace

Draft::Draft(Messages& messages, std::function<void()> wake, std::size_t history_bytes)
    : messages_(messages),
      document_(empty_document()),
      history_(history_bytes),
      selection_(document_, messages),
      solving_(std::move(wake)) {}

void Draft::update() {
  if (std::exchange(targets_moved_, false)) solving_.move_targets(document_);
  solving_.begin();
  if (!solving_.poll()) return;
  take_newest();
  messages_.redraw();
}

void Draft::take_newest() {
  document_.standing = solving_.standing();
  const auto& newest = solving_.newest();
  if (!newest || newest == taken_) return;
  taken_ = newest;
  const auto pose = adopted_pose(newest, *document_.pose);
  folded_ = pose->is_valid() ? nullptr : pose;
  if (pose->is_valid()) document_.pose = pose;
  refresh_shown();
}

const std::shared_ptr<const Snapshot>& Draft::pose_on_screen() const {
  if (look_back_) return look_back_->pose;
  return folded_ ? folded_ : document_.pose;
}

void Draft::refresh_shown() {
  messages_.redraw();
  paint_order_.set_parts(document_.parts);
  const std::shared_ptr<const Snapshot>& pose = pose_on_screen();
  if (document_.is_empty()) {
    shown_ = nullptr;
  } else if (look_back_ || pose->handles == document_.handles) {
    shown_ = pose;
  } else {
    auto with_handles = std::make_shared<Snapshot>(*pose);
    with_handles->handles = document_.handles;
    shown_ = std::move(with_handles);
  }
  if (pose == proved_) return;
  proved_ = pose;
  proof_ = pose ? proof_of(*pose) : Proof{};
}

/// What was merged so far is a step of its own, even where the edit is given up.
void Draft::begin_edit() {
  seal();
  edit_ = Edit{document_, solving_.is_running()};
  take_over_look_back();
}

void Draft::take_over_look_back() {
  if (!look_back_) return;
  if (look_back_->pose->is_valid()) {
    document_.handles = look_back_->pose->handles;
    document_.pose = look_back_->pose;
  } else {
    messages_.toast(ToastKind::notice, std::string(kFoldedMapLeft));
  }
  look_at_newest();
  solving_.hold();
}

void Draft::apply(Document document, Change change) {
  document_ = std::move(document);
  if (change != Change::appearance) {
    document_.standing = {};
    if (std::exchange(folded_, nullptr))
      messages_.toast(ToastKind::notice, std::string(kFoldedMapLeft));
  }
  if (change == Change::targets) targets_moved_ = true;
  if (change == Change::parameters) solving_.set_parameters(document_);
  if (change == Change::mesh) {
    targets_moved_ = false;
    selection_.prune();
    solving_.start(document_);
  }
  refresh_shown();
}

void Draft::replace(const Document& document) {
  document_ = document;
  show_document();
}

void Draft::show_document() {
  targets_moved_ = false;
  taken_ = nullptr;
  folded_ = nullptr;
  look_at_newest();
  solving_.hold();
  selection_.prune();
  refresh_shown();
}

void Draft::commit(std::string label) {
  last_change_.reset();
  if (edit_ && complete_) complete_(edit_->before, document_);
  edit_.reset();
  history_.push(std::move(label), document_);
  messages_.redraw();
}

void Draft::abandon_edit() {
  if (!edit_) return;
  const Edit abandoned = *std::exchange(edit_, std::nullopt);
  replace(abandoned.before);
  if (abandoned.was_solving) solving_.start(document_);
}

void Draft::edit(std::string label, Document document, Change change) {
  const std::shared_ptr<const Snapshot> newest = document_.pose;
  begin_edit();
  if (document_.pose != newest && document.pose == newest) {
    document.pose = document_.pose;
    document.handles = document_.handles;
  }
  apply(std::move(document), change);
  commit(std::move(label));
}

void Draft::edit_again(const std::string& label, Document document, Change change) {
  const double now = messages_.now();
  if (last_change_ && last_change_->label == label && now - last_change_->time < kMergeSeconds) {
    const Document before = document_;
    apply(std::move(document), change);
    if (complete_) complete_(before, document_);
    history_.refresh(document_);
  } else {
    edit(label, std::move(document), change);
  }
  last_change_ = LastChange{label, now};
}

void Draft::seal() {
  last_change_.reset();
  history_.refresh(document_);
}

void Draft::undo() {
  if (interrupt()) return;
  if (history_.can_undo()) jump_to_step(history_.current() - 1);
}

void Draft::redo() {
  interrupt();
  if (history_.can_redo()) jump_to_step(history_.current() + 1);
}

void Draft::jump_to_step(std::size_t index) {
  interrupt();
  if (index >= history_.steps().size() || index == history_.current()) return;
  seal();
  replace(history_.jump(index));
}

// What takes most memory comes first.
void Draft::install(Document document, std::string label) {
  const std::shared_ptr<const Snapshot> pose = document.pose;
  const Proof proof = pose ? proof_of(*pose) : Proof{};
  history_.reset(std::move(label), document);
  document_ = std::move(document);
  proved_ = pose;
  proof_ = proof;
  last_change_.reset();
  selection_.select_none();
  selection_.hover(std::nullopt);
  show_document();
}

void Draft::look_at(LookBack iteration) {
  look_back_ = std::move(iteration);
  refresh_shown();
}

void Draft::look_at_newest() {
  if (!look_back_) return;
  look_back_.reset();
  refresh_shown();
}

}  // namespace foldless
