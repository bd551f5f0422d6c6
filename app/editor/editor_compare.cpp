// SPDX-License-Identifier: GPL-3.0-or-later
// The editor beside itself: rest and deformed mesh next to each other, and the race.
#include <utility>

#include "app/editor/editor.h"

namespace foldless {

void Editor::toggle_remesh_diff() {
  remesh_diff_.show(!remesh_diff_.is_shown());
  // The canvas changes its size next.
  needs_fit_ = true;
  redraw();
}

void Editor::toggle_link() {
  if (remesh_diff_.is_linked())
    remesh_diff_.unlink();
  else
    remesh_diff_.link(canvas_.camera);
  redraw();
}

void Editor::set_rest_camera(const Camera& camera) {
  canvas_.camera = remesh_diff_.move(camera, canvas_.camera);
  redraw();
}

void Editor::toggle_race() {
  cancel_gesture();
  if (race_.is_open()) {
    race_.close();
  } else if (!document_.handles.empty()) {
    race_.set_pace(pace_);
    race_.open(document_);
  }
  redraw();
}

void Editor::use_race_lane(std::size_t index) {
  const RaceLane& lane = *race_.lanes().at(index);
  if (lane.proof().folds())
    return toast(ToastKind::error, "That map folds; the editor keeps to maps that do not.");
  begin_edit();
  Document document = document_;
  document.standing = {};
  document.pose = adopted_pose(lane.shown(), *document_.pose);
  document.handles = lane.shown()->handles;
  document.parameters = lane.parameters();
  restore(document);
  document_.standing.satisfied = lane.is_at_targets();
  if (lane.is_at_end()) {
    document_.standing.outcome = lane.outcome();
    document_.standing.verdict = lane.verdict();
  }
  const std::string label = "Use the result of " + lane.title();
  race_.close();
  commit(label);
}

}  // namespace foldless
