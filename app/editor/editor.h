// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "app/editor/bone_tool.h"
#include "app/editor/canvas_view.h"
#include "app/editor/document_edits.h"
#include "app/editor/document_files.h"
#include "app/editor/draft.h"
#include "app/editor/editor_input.h"
#include "app/editor/handle_view.h"
#include "app/editor/keymap.h"
#include "app/editor/messages.h"
#include "app/editor/motion.h"
#include "app/editor/playback.h"
#include "app/editor/pose_comparison.h"
#include "app/editor/race.h"
#include "app/editor/status.h"
#include "app/editor/stiffness_brush.h"
#include "app/editor/stuck_help.h"

namespace foldless {

/// What an editor needs from outside.
struct EditorOptions {
  /// Holds the recent files and copies of unsaved work; empty: nothing is kept on disk.
  std::filesystem::path state_folder = {};
  std::function<void()> wake = {};  ///< called on the solver's thread when update() has news
  std::size_t history_bytes = std::size_t{1} << 30;
};

/// The program without its window: a document, its history, what is selected and seen, and the
/// solver behind it. Takes plain input events, says what to draw. One thread only. Never throws on
/// bad files or refused edits: it shows a toast. An edit that comes in the middle of a gesture
/// cancels the gesture.
class Editor {
 public:
  explicit Editor(const EditorOptions& options = {});
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  // The loop: events in, then one update a frame. `now` is a clock that never goes back. [s]

  void receive(const InputEvent& event, double now);
  /// Sends the newest targets to the solver and takes its newest state. Returns whether something
  /// on screen may have changed since the last call.
  bool update(double now);
  /// When update() must be called again though nothing happens (a toast goes away), if ever. [s]
  std::optional<double> next_wake() const;
  /// Runs a command of the table if it is enabled; returns whether it was.
  bool run_command(std::string_view name);
  /// Stages of Esc: leave import, recovery or race, cancel the gesture, end the
  /// bones that are drawn, put the tool away, stop solving, stop playing, leave the iteration that
  /// is shown, leave the kept pose beside the canvas, deselect keys, deselect handles.
  void escape();

  // Its parts.

  Draft& draft() { return draft_; }
  const Draft& draft() const { return draft_; }
  DocumentEdits& edits() { return edits_; }
  DocumentFiles& files() { return files_; }
  const DocumentFiles& files() const { return files_; }
  Selection& selection() { return draft_.selection(); }
  const Selection& selection() const { return draft_.selection(); }
  CanvasView& view() { return view_; }
  const CanvasView& view() const { return view_; }
  Playback& playback() { return playback_; }
  const Playback& playback() const { return playback_; }
  Motion& motion() { return motion_; }
  const Motion& motion() const { return motion_; }
  PoseComparison& comparison() { return comparison_; }
  const PoseComparison& comparison() const { return comparison_; }
  StiffnessBrush& brush() { return brush_; }
  const StiffnessBrush& brush() const { return brush_; }
  BoneTool& bone_tool() { return bone_tool_; }
  const BoneTool& bone_tool() const { return bone_tool_; }
  StuckHelp& stuck() { return stuck_; }
  const StuckHelp& stuck() const { return stuck_; }
  Messages& messages() { return messages_; }
  const Messages& messages() const { return messages_; }
  /// Which key asks for what.
  Keymap& keys() { return keys_; }
  const Keymap& keys() const { return keys_; }
  EditorInput& input() { return input_; }
  const EditorInput& input() const { return input_; }

  // What is asked for everywhere.

  const Document& document() const { return draft_.document(); }
  /// The mesh on screen, see Draft::shown().
  const std::shared_ptr<const Snapshot>& shown() const { return draft_.shown(); }
  const Canvas& canvas() const { return view_.canvas(); }
  Status status() const;

  // The race of methods.

  Race& race() { return race_; }
  const Race& race() const { return race_; }
  /// Opens a race with the document's handles, or closes it; the document stays as it is.
  void toggle_race();
  /// Closes the race; what a lane shows, and how it was made, becomes the document: an undo step.
  void use_race_lane(std::size_t index);

 private:
  Messages messages_;
  Draft draft_;
  Race race_;
  PoseComparison comparison_;
  CanvasView view_;
  Playback playback_;
  Motion motion_;
  DocumentEdits edits_;
  DocumentFiles files_;
  StuckHelp stuck_;
  StiffnessBrush brush_;
  BoneTool bone_tool_;
  Keymap keys_;
  EditorInput input_;
};

}  // namespace foldless
