// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/editor.h"

// What the rows of the table of commands are made of.

namespace foldless {

inline constexpr Modifiers kNone{};
inline constexpr Modifiers kShift{.shift = true};
inline constexpr Modifiers kAlt{.alt = true};
inline constexpr Modifiers kControl{.control = true};
inline constexpr Modifiers kControlShift{.shift = true, .control = true};

inline bool always(const Editor&) { return true; }
inline bool has_mesh(const Editor& e) { return !e.document().is_empty(); }
inline bool has_handles(const Editor& e) { return !e.document().handles.empty(); }
inline bool has_selection(const Editor& e) { return !e.selection().ids().empty(); }
inline bool has_several(const Editor& e) { return e.selection().ids().size() > 1; }
inline bool has_race(const Editor& e) { return e.race().is_open(); }
inline bool has_time_line(const Editor& e) { return e.motion().is_open(); }
inline bool has_keys_selected(const Editor& e) { return !e.motion().keys().selected().empty(); }
inline bool has_iterations(const Editor& e) {
  return has_race(e) ? e.race().furthest() > 0 : !e.playback().iterations().empty();
}

// The part of an editor that has a member function.

inline Editor& part_with(void (Editor::*)(), Editor& e) { return e; }
inline Draft& part_with(void (Draft::*)(), Editor& e) { return e.draft(); }
inline DocumentEdits& part_with(void (DocumentEdits::*)(), Editor& e) { return e.edits(); }
inline DocumentFiles& part_with(void (DocumentFiles::*)(), Editor& e) { return e.files(); }
inline Selection& part_with(void (Selection::*)(), Editor& e) { return e.selection(); }
inline CanvasView& part_with(void (CanvasView::*)(), Editor& e) { return e.view(); }
inline Motion& part_with(void (Motion::*)(), Editor& e) { return e.motion(); }
inline PlayHead& part_with(void (PlayHead::*)(), Editor& e) { return e.motion().play_head(); }
inline MotionKeys& part_with(void (MotionKeys::*)(), Editor& e) { return e.motion().keys(); }
inline Playback& part_with(void (Playback::*)(), Editor& e) { return e.playback(); }
inline PoseComparison& part_with(void (PoseComparison::*)(), Editor& e) { return e.comparison(); }
inline StiffnessBrush& part_with(void (StiffnessBrush::*)(), Editor& e) { return e.brush(); }
inline BoneTool& part_with(void (BoneTool::*)(), Editor& e) { return e.bone_tool(); }
inline StuckHelp& part_with(void (StuckHelp::*)(), Editor& e) { return e.stuck(); }

/// A member function of a part as an action.
template <auto Function>
void call(Editor& e) {
  (part_with(Function, e).*Function)();
}

template <void (Race::*InRace)(), auto InEditor>
void transport(Editor& e) {
  if (has_race(e))
    (e.race().*InRace)();
  else
    call<InEditor>(e);
}

template <auto InRace, auto InMotion, auto InEditor>
void transport(Editor& e) {
  if (has_race(e))
    (e.race().*InRace)();
  else if (has_time_line(e))
    call<InMotion>(e);
  else
    call<InEditor>(e);
}

template <Request R>
void ask(Editor& e) {
  e.messages().request(R);
}

/// The same command, in a race too.
inline Command in_race(Command command) {
  command.in_race = true;
  return command;
}

/// The same command, run again while its key is held down.
inline Command repeating(Command command) {
  command.repeats = true;
  return command;
}

}  // namespace foldless
