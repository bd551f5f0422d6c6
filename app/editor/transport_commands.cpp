// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/transport_commands.h"

#include "app/editor/command_parts.h"

namespace foldless {
namespace {

bool is_scrubbed(const Editor& e) { return e.playback().scrubbed().has_value(); }
bool can_play(const Editor& e) {
  return e.playback().can_scrub() && e.playback().iterations().size() > 1;
}
bool is_solving(const Editor& e) { return e.playback().is_solving(); }
bool is_stuck(const Editor& e) { return e.stuck().handle() != nullptr; }
bool has_frames(const Editor& e) { return has_time_line(e) && e.motion().has_keys(); }

// The transport works on the race while there is one, else on the time line while it is open.

bool is_paused(const Editor& e) {
  if (has_race(e)) return !e.race().is_playing() && !e.race().is_finished();
  if (has_time_line(e)) return !e.motion().play_head().is_playing();
  return e.playback().state() == SolvingState::paused;
}
bool can_go_back(const Editor& e) {
  if (!has_race(e) && has_time_line(e)) return true;
  return has_race(e) ? e.race().tick() > 0 : !e.playback().iterations().empty();
}
bool can_go_to_first(const Editor& e) {
  if (!has_race(e) && has_time_line(e)) return true;
  return has_race(e) ? can_go_back(e) : e.playback().can_scrub();
}
bool can_go_to_last(const Editor& e) {
  if (!has_race(e) && has_time_line(e)) return true;
  return has_race(e) ? e.race().tick() < e.race().furthest() : is_scrubbed(e);
}

// A table reads best with one row a line.
// clang-format off

std::vector<Command> solve_commands() {
  return {
      in_race({"solve.toggle", "Solve", "Pause or resume", {{Key::space, kNone}}, has_mesh, transport<&Race::toggle, &PlayHead::toggle_play, &Playback::toggle_pause>, is_paused}),
      {"solve.stop", "Solve", "Stop", {}, is_solving, call<&Playback::stop>},
      in_race(repeating({"solve.step", "Solve", "Next iteration or frame", {{Key::period, kNone}}, has_handles, transport<&Race::step_forward, &PlayHead::step_forward, &Playback::step_forward>})),
      in_race(repeating({"solve.back", "Solve", "Previous iteration or frame", {{Key::comma, kNone}}, can_go_back, transport<&Race::step_back, &PlayHead::step_back, &Playback::step_back>})),
      in_race({"solve.first", "Solve", "First iteration or frame", {{Key::comma, kShift}}, can_go_to_first, transport<&Race::first_tick, &PlayHead::first, &Playback::first>}),
      in_race({"solve.last", "Solve", "Newest iteration, last frame", {{Key::period, kShift}}, can_go_to_last, transport<&Race::last_tick, &PlayHead::last, &Playback::last>}),
      {"solve.play", "Solve", "Play the iterations", {{Key::p, kNone}}, can_play, call<&Playback::toggle_play>, [](const Editor& e) { return e.playback().is_playing(); }},
      {"solve.loop", "Solve", "Play them again and again", {{Key::p, kShift}}, has_mesh, call<&Playback::toggle_loop>, [](const Editor& e) { return e.playback().loops(); }},
      {"solve.use", "Solve", "Use this iteration", {{Key::enter, kNone}}, is_scrubbed, call<&Playback::use_iteration>},
      {"stuck.toggle", "Solve", "Why is it stuck?", {{Key::w, kNone}}, has_handles, call<&StuckHelp::toggle>, [](const Editor& e) { return e.stuck().is_shown(); }},
      {"stuck.flip", "Solve", "Flip the edges in the way", {{Key::f, kShift}}, is_stuck, call<&StuckHelp::flip_blocking>},
      {"stuck.split", "Solve", "Split the edges in the way", {{Key::s, kShift}}, is_stuck, call<&StuckHelp::split_blocking>},
      in_race({"race.toggle", "Solve", "Race of methods", {{Key::m, kNone}}, has_handles, call<&Editor::toggle_race>, has_race}),
      in_race({"race.restart", "Solve", "Start the race again", {{Key::m, kShift}}, has_race, [](Editor& e) { e.race().restart(); }}),
  };
}

std::vector<Command> motion_commands() {
  return {
      {"motion.toggle", "Motion", "Time line", {{Key::t, kNone}}, has_mesh, call<&Motion::toggle>, has_time_line},
      {"motion.key", "Motion", "Set keys here", {{Key::i, kNone}}, [](const Editor& e) { return has_time_line(e) && has_handles(e); }, call<&MotionKeys::key_handles>},
      {"motion.record", "Motion", "Moved handles get keys", {{Key::i, kShift}}, has_time_line, call<&MotionKeys::toggle_records>, [](const Editor& e) { return e.motion().keys().records(); }},
      repeating({"motion.next_key", "Motion", "Next key", {{Key::period, kAlt}}, has_frames, call<&PlayHead::next_key>}),
      repeating({"motion.previous_key", "Motion", "Previous key", {{Key::comma, kAlt}}, has_frames, call<&PlayHead::previous_key>}),
      {"motion.copy", "Motion", "Copy keys", {{Key::c, kControl}}, has_keys_selected, call<&MotionKeys::copy>},
      {"motion.paste", "Motion", "Paste keys at the play head", {{Key::v, kControl}}, [](const Editor& e) { return has_time_line(e) && e.motion().keys().can_paste(); }, call<&MotionKeys::paste>},
      {"motion.select_keys", "Motion", "Select all keys", {}, has_frames, [](Editor& e) { e.motion().keys().select(keys_of(e.motion().animation())); }},
      {"motion.smooth", "Motion", "Smooth paths", {}, [](const Editor& e) { return has_frames(e) && has_selection(e); }, call<&MotionKeys::toggle_smooth>, [](const Editor& e) { return e.motion().keys().is_smooth(); }},
      {"motion.swing", "Motion", "Swing about the handle selected last", {}, [](const Editor& e) { return has_frames(e) && (has_several(e) || e.motion().keys().swings()); }, call<&MotionKeys::toggle_swing>, [](const Editor& e) { return e.motion().keys().swings(); }},
      {"motion.onion_skin", "Motion", "Outlines of the keys before and after", {{Key::u, kNone}}, has_time_line, call<&Motion::toggle_onion_skin>, [](const Editor& e) { return e.motion().has_onion_skin(); }},
  };
}

// clang-format on

}  // namespace

std::vector<Command> transport_commands() {
  std::vector<Command> table = solve_commands();
  const std::vector<Command> motion = motion_commands();
  table.insert(table.end(), motion.begin(), motion.end());
  return table;
}

}  // namespace foldless
