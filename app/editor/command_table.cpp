// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/command_table.h"

#include <array>

#include "app/editor/editor.h"

namespace foldless {
namespace {

constexpr Modifiers kNone{};
constexpr Modifiers kShift{.shift = true};
constexpr Modifiers kControl{.control = true};
constexpr Modifiers kControlShift{.shift = true, .control = true};
constexpr double kZoomStep = 1.25;

bool always(const Editor&) { return true; }
bool has_mesh(const Editor& e) { return !e.document().is_empty(); }
bool has_handles(const Editor& e) { return !e.document().handles.empty(); }
bool has_selection(const Editor& e) { return !e.selection().empty(); }
bool has_texture(const Editor& e) { return !e.document().texture.empty(); }
bool has_iterations(const Editor& e) { return !e.iterations().empty(); }
bool can_undo(const Editor& e) { return e.is_editing() || e.history().can_undo(); }
bool can_redo(const Editor& e) { return e.history().can_redo(); }
bool can_scrub(const Editor& e) { return e.can_scrub(); }
bool is_scrubbed(const Editor& e) { return e.scrubbed().has_value(); }
bool is_solving(const Editor& e) { return e.is_solving(); }
bool is_paused(const Editor& e) { return e.solving_state() == SolvingState::paused; }

template <Request R>
void ask(Editor& e) {
  e.request(R);
}

/// A member function of Editor as an action.
template <void (Editor::*Function)()>
void call(Editor& e) {
  (e.*Function)();
}

template <std::size_t K>
void toggle_layer(Editor& e) {
  bool& shown = e.view().layers.*kLayerRows[K].shown;
  shown = !shown;
}

template <std::size_t K>
bool is_layer_on(const Editor& e) {
  return e.view().layers.*kLayerRows[K].shown;
}

// A table reads best with one row a line.
// clang-format off

template <std::size_t K>
Command layer(std::string_view name) {
  const auto key = static_cast<Key>(static_cast<int>(Key::digit_1) + static_cast<int>(K));
  return {name, "View", kLayerRows[K].title, {{key, kNone}}, always, toggle_layer<K>, is_layer_on<K>};
}

/// The same command, run again while its key is held down.
Command repeating(Command command) {
  command.repeats = true;
  return command;
}

std::vector<Command> file_commands() {
  return {
      {"file.new", "File", "New", {{Key::n, kControl}}, always, call<&Editor::new_document>},
      {"file.open", "File", "Open\u2026", {{Key::o, kControl}}, always, ask<Request::open_dialog>},
      {"file.save", "File", "Save", {{Key::s, kControl}}, has_mesh, call<&Editor::save>},
      {"file.save_as", "File", "Save as\u2026", {{Key::s, kControlShift}}, has_mesh, ask<Request::save_dialog>},
      {"file.texture", "File", "Choose texture\u2026", {}, has_mesh, ask<Request::texture_dialog>},
      {"file.clear_texture", "File", "Remove texture", {}, has_texture, call<&Editor::clear_texture>},
      {"file.snapshot", "File", "Save picture", {{Key::f12, kNone}}, has_mesh, ask<Request::write_snapshot>},
      {"file.export", "File", "Export\u2026", {{Key::e, kControl}}, has_mesh, ask<Request::export_dialog>},
      {"file.export_again", "File", "Export again", {{Key::e, kControlShift}}, has_mesh, ask<Request::export_again>},
      {"file.quit", "File", "Quit", {{Key::q, kControl}}, always, call<&Editor::close>},
  };
}

std::vector<Command> edit_commands() {
  return {
      repeating({"edit.undo", "Edit", "Undo", {{Key::z, kControl}}, can_undo, call<&Editor::undo>}),
      repeating({"edit.redo", "Edit", "Redo", {{Key::z, kControlShift}, {Key::y, kControl}}, can_redo, call<&Editor::redo>}),
      {"edit.delete", "Edit", "Delete handles", {{Key::del, kNone}, {Key::backspace, kNone}}, has_selection, call<&Editor::delete_selected>},
      {"edit.reset_pose", "Edit", "Reset pose", {{Key::r, kControl}}, has_mesh, call<&Editor::reset_pose>},
      {"select.all", "Edit", "Select all", {{Key::a, kControl}}, has_handles, call<&Editor::select_all>},
      {"select.none", "Edit", "Select none", {{Key::a, kControlShift}}, has_selection, [](Editor& e) { e.select({}); }},
      {"select.invert", "Edit", "Invert selection", {{Key::i, kControl}}, has_handles, call<&Editor::invert_selection>},
      {"edit.escape", "Edit", "Cancel, stop or deselect", {{Key::escape, kNone}}, always, call<&Editor::escape>},
  };
}

std::vector<Command> solve_commands() {
  return {
      {"solve.toggle", "Solve", "Pause or resume", {{Key::space, kNone}}, has_mesh, call<&Editor::toggle_pause>, is_paused},
      {"solve.stop", "Solve", "Stop", {}, is_solving, call<&Editor::stop_solving>},
      repeating({"solve.step", "Solve", "Next iteration", {{Key::period, kNone}}, has_handles, call<&Editor::step_forward>}),
      repeating({"solve.back", "Solve", "Previous iteration", {{Key::comma, kNone}}, has_iterations, call<&Editor::step_back>}),
      {"solve.first", "Solve", "First iteration", {{Key::comma, kShift}}, can_scrub, call<&Editor::first_iteration>},
      {"solve.last", "Solve", "Newest iteration", {{Key::period, kShift}}, is_scrubbed, call<&Editor::last_iteration>},
      {"solve.use", "Solve", "Use this iteration", {{Key::enter, kNone}}, is_scrubbed, call<&Editor::use_iteration>},
  };
}

std::vector<Command> view_commands() {
  return {
      repeating({"view.zoom_in", "View", "Zoom in", {{Key::plus, kNone}, {Key::plus, kShift}}, always, [](Editor& e) { e.zoom(kZoomStep); }}),
      repeating({"view.zoom_out", "View", "Zoom out", {{Key::minus, kNone}}, always, [](Editor& e) { e.zoom(1 / kZoomStep); }}),
      {"view.fit", "View", "Fit all", {{Key::home, kNone}}, has_mesh, call<&Editor::fit_all>},
      {"view.fit_selection", "View", "Fit selection", {{Key::f, kNone}}, has_mesh, call<&Editor::fit_selection>},
      {"view.actual_size", "View", "100 %", {{Key::digit_0, kControl}}, always, call<&Editor::actual_size>},
      layer<0>("view.fill"),
      layer<1>("view.wireframe"),
      layer<2>("view.boundary"),
      layer<3>("view.heat"),
      layer<4>("view.handles"),
      layer<5>("view.remeshed"),
      layer<6>("view.rest"),
      {"view.hide_overlays", "View", "Hide overlays while held", {{Key::h, kNone}}, always,
       [](Editor& e) { e.hide_overlays(true); },
       [](const Editor& e) { return e.are_overlays_hidden(); },
       [](Editor& e) { e.hide_overlays(false); }},
      {"help.search", "Help", "Search commands\u2026", {{Key::k, kControl}}, always, ask<Request::command_search>},
      {"help.keys", "Help", "Shortcuts", {{Key::f1, kNone}}, always, ask<Request::cheat_sheet>},
  };
}

// clang-format on

}  // namespace

std::vector<Command> command_table() {
  std::vector<Command> table;
  for (const auto& part : {file_commands(), edit_commands(), solve_commands(), view_commands()})
    table.insert(table.end(), part.begin(), part.end());
  return table;
}

}  // namespace foldless
