// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/edits.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

/// Moves of one slider that follow each other this closely make one undo step. [s]
constexpr double kMergeSeconds = 1;

constexpr std::string_view kFoldedMapLeft =
    "The map on screen was folded; the edit goes on from the last valid one";

}  // namespace

void Editor::begin_edit() {
  history_.refresh(document_);
  edit_ = Edit{document_, solving_.is_running()};
  if (!scrubbed_) return;
  if (old_pose_->is_valid()) {
    document_.handles = old_pose_->handles;
    document_.pose = old_pose_;
  } else {
    toast(ToastKind::notice, std::string(kFoldedMapLeft));
  }
  leave_timeline();
  solving_.hold();
}

void Editor::apply(Document document, Change change) {
  document_ = std::move(document);
  if (change != Change::appearance) {
    document_.standing = {};
    if (std::exchange(folded_, nullptr)) toast(ToastKind::notice, std::string(kFoldedMapLeft));
  }
  if (change == Change::targets) targets_moved_ = true;
  if (change == Change::parameters) solving_.set_parameters(document_);
  if (change == Change::mesh) {
    targets_moved_ = false;
    solving_.start(document_);
  }
  refresh_shown();
}

void Editor::commit(std::string label) {
  last_change_.reset();
  edit_.reset();
  history_.push(std::move(label), document_);
  redraw();
}

void Editor::abandon_edit() {
  if (!edit_) return;
  const Edit abandoned = *std::exchange(edit_, std::nullopt);
  restore(abandoned.before);
  if (abandoned.was_solving) solving_.start(document_);
}

void Editor::edit(std::string label, Document document, Change change) {
  begin_edit();
  apply(std::move(document), change);
  commit(std::move(label));
}

void Editor::restore(const Document& document) {
  document_ = document;
  targets_moved_ = false;
  taken_ = nullptr;
  folded_ = nullptr;
  leave_timeline();
  solving_.hold();
  prune_selection();
  refresh_shown();
}

void Editor::undo() {
  if (!tool_->is_idle()) return cancel_gesture();
  if (history_.can_undo()) jump_to_step(history_.current() - 1);
}

void Editor::redo() {
  cancel_gesture();
  if (history_.can_redo()) jump_to_step(history_.current() + 1);
}

void Editor::jump_to_step(std::size_t index) {
  cancel_gesture();
  if (index >= history_.steps().size() || index == history_.current()) return;
  history_.refresh(document_);
  last_change_.reset();
  restore(history_.jump(index));
}

void Editor::delete_selected() {
  cancel_gesture();
  if (selection_.empty()) return;
  begin_edit();
  const std::string label = selection_.size() == 1 ? "Delete handle" : "Delete handles";
  apply(without_handles(document_, selection_), Change::mesh);
  prune_selection();
  commit(label);
}

void Editor::change_selected(const std::string& label, const std::function<void(Handle&)>& change) {
  cancel_gesture();
  const auto changed = [&](std::vector<Handle> handles) {
    for (Handle& handle : handles)
      if (selection_.contains(handle.id)) change(handle);
    return handles;
  };
  if (changed(document_.handles) == document_.handles) return;
  begin_edit();
  document_.handles = changed(document_.handles);  // those of the iteration that is shown, if any
  apply(document_, Change::appearance);
  commit(label);
}

void Editor::reset_pose() {
  cancel_gesture();
  if (document_.is_empty()) return;
  begin_edit();
  apply(in_rest_pose(document_), Change::mesh);
  prune_selection();
  commit("Reset pose");
}

void Editor::change_parameters(const std::string& label, Document document) {
  const bool merges =
      last_change_ && last_change_->label == label && now_ - last_change_->time < kMergeSeconds;
  if (merges) {
    apply(std::move(document), Change::parameters);
    history_.refresh(document_);
  } else {
    edit(label, std::move(document), Change::parameters);
  }
  last_change_ = LastChange{label, now_};
}

void Editor::set_energy(const Density& energy) {
  cancel_gesture();
  if (document_.energy == &energy) return;
  Document document = document_;
  document.energy = &energy;
  edit("Energy: " + std::string(energy.title), std::move(document), Change::parameters);
}

void Editor::set_method(std::string_view name) {
  cancel_gesture();
  const MethodRow* method = find_method(name);
  if (!method || document_.parameters.method == name) return;
  Document document = document_;
  document.parameters.method = name;
  edit("Method: " + std::string(method->title), std::move(document), Change::parameters);
}

void Editor::set_parameter(const ParameterRow& row, double value) {
  cancel_gesture();
  if (!std::isfinite(value)) return;
  value = std::clamp(value, row.minimum, row.maximum);
  if (row.get(document_.parameters, *document_.energy) == value) return;
  Document document = document_;
  row.set(document.parameters, value);
  change_parameters(std::string(row.title), std::move(document));
}

void Editor::reset_parameter(const ParameterRow& row) {
  cancel_gesture();
  if (!is_changed(row, document_.parameters, *document_.energy)) return;
  Document document = document_;
  row.reset(document.parameters);
  edit("Reset " + std::string(row.title), std::move(document), Change::parameters);
}

}  // namespace foldless
