// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {

void Editor::toggle_pause() {
  if (document_.is_empty()) return;
  leave_timeline();
  solving_.toggle_pause(document_);
  redraw();
}

void Editor::stop_solving() {
  solving_.stop();
  redraw();
}

void Editor::set_pace(std::optional<double> pace) {
  if (pace) pace = std::clamp(*pace, 1.0, 60.0);
  pace_ = pace;
  solving_.set_pace(pace);
  race_.set_pace(pace);
  redraw();
}

bool Editor::can_scrub() const {
  return !solving_.is_running() && !is_editing() && !iterations().empty();
}

void Editor::scrub(std::size_t index) {
  if (!can_scrub()) return;
  if (index + 1 >= iterations().size()) return leave_timeline();
  const auto snapshot = solving_.snapshot_of(index);
  if (!snapshot) return toast(ToastKind::notice, "That iteration was let go to save memory");
  scrubbed_ = index;
  old_pose_ = with_depths_of(document_, adopted_pose(snapshot, *document_.pose));
  refresh_shown();
}

void Editor::leave_timeline() {
  if (!scrubbed_) return;
  scrubbed_.reset();
  old_pose_ = nullptr;
  refresh_shown();
}

void Editor::use_iteration() {
  cancel_gesture();
  if (!scrubbed_) return;
  if (!old_pose_->is_valid())
    return toast(ToastKind::error, "This iteration is folded; choose one that is not");
  const std::string label = "Use iteration " + std::to_string(*scrubbed_ + 1);
  begin_edit();
  document_.standing = {};
  commit(label);
  refresh_shown();
}

void Editor::step_forward() {
  if (scrubbed_) return scrub(*scrubbed_ + 1);
  solving_.step(document_);
  redraw();
}

void Editor::step_back() {
  if (solving_.is_running()) {
    solving_.pause();
    redraw();
  }
  const std::size_t shown = scrubbed_.value_or(iterations().empty() ? 0 : iterations().size() - 1);
  if (shown > 0) scrub(shown - 1);
}

void Editor::first_iteration() { scrub(0); }

void Editor::last_iteration() { leave_timeline(); }

void Editor::escape() {
  if (import_.is_open()) return close_import();
  if (race_.is_open()) return toggle_race();
  if (!tool_->is_idle()) return cancel_gesture();
  if (solving_.is_running()) return stop_solving();
  if (scrubbed_) return leave_timeline();
  select({});
}

}  // namespace foldless
