// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/editor/commands.h"

namespace foldless {

Editor::Editor(const EditorOptions& options)
    : draft_(messages_, options.wake, options.history_bytes),
      race_(options.wake),
      comparison_(draft_, messages_),
      view_(draft_, comparison_, messages_),
      playback_(draft_, race_, messages_),
      motion_(draft_, messages_, options.wake),
      edits_(draft_),
      files_({draft_, view_, race_, messages_}, options.state_folder, options.wake),
      stuck_(draft_, messages_),
      brush_(draft_),
      bone_tool_(draft_),
      input_(*this) {
  draft_.on_interrupt([this] { return input_.cancel_gesture(); });
}

Editor::~Editor() = default;

void Editor::receive(const InputEvent& event, double now) {
  messages_.tick(now);
  input_.receive(event);
}

bool Editor::update(double now) {
  messages_.tick(now);
  draft_.update();
  playback_.update();
  if (!race_.is_open()) motion_.update();
  files_.update();
  if (race_.update(now)) messages_.redraw();
  stuck_.update(!playback_.is_solving() && !draft_.is_editing() && !draft_.look_back() &&
                !race_.is_open() && !draft_.proof().folds());
  return messages_.take_redraw();
}

std::optional<double> Editor::next_wake() const {
  std::optional<double> next;
  for (const auto& wake : {race_.next_wake(), messages_.next_wake(), files_.autosave().next_wake(),
                           playback_.next_wake(), motion_.next_wake()})
    if (wake) next = std::min(next.value_or(*wake), *wake);
  return next;
}

bool Editor::run_command(std::string_view name) {
  const Command* command = find_command(name);
  if (!command || !is_available(*command, *this)) return false;
  command->run(*this);
  messages_.redraw();
  return true;
}

void Editor::escape() {
  if (files_.image_import().is_open()) return files_.close_import();
  if (files_.recovery().is_open()) return files_.recovery().close();
  if (race_.is_open()) return toggle_race();
  if (input_.cancel_gesture()) return;
  if (!bone_tool_.chain().empty()) return bone_tool_.end_chain();
  if (bone_tool_.is_on()) return bone_tool_.toggle();
  if (brush_.is_on()) return brush_.toggle();
  if (playback_.is_solving()) return playback_.stop();
  if (playback_.is_playing()) return playback_.toggle_play();
  if (motion_.play_head().is_playing()) return motion_.play_head().toggle_play();
  if (playback_.scrubbed()) return draft_.look_at_newest();
  if (view_.beside() == Beside::kept_pose) return view_.toggle_beside(Beside::kept_pose);
  if (!motion_.keys().selected().empty()) return motion_.keys().select_none();
  selection().select_none();
}

Status Editor::status() const {
  const bool shows_frame = draft_.look_back() && !draft_.look_back()->iteration;
  return shows_frame ? status_of(motion_) : status_of(draft_);
}

void Editor::toggle_race() {
  draft_.interrupt();
  if (race_.is_open())
    race_.close();
  else if (!document().handles.empty())
    race_.open(document());
  messages_.redraw();
}

void Editor::use_race_lane(std::size_t index) {
  const RaceLane& lane = *race_.lanes().at(index);
  if (lane.proof().folds())
    return messages_.toast(ToastKind::error,
                           "That map folds; the editor keeps to maps that do not.");
  draft_.begin_edit();
  Document document = draft_.document();
  document.pose = adopted_pose(lane.shown(), *document.pose);
  document.handles = lane.shown()->handles;
  document.parameters = lane.parameters();
  document.energy = &lane.energy();
  document.standing = {};
  document.standing.satisfied = lane.is_at_targets();
  if (lane.is_at_end()) {
    document.standing.outcome = lane.outcome();
    document.standing.verdict = lane.verdict();
  }
  const std::string label = "Use the result of " + lane.title();
  draft_.replace(document);
  race_.close();
  draft_.commit(label);
}

}  // namespace foldless
