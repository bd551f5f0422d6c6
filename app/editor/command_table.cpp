// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/command_table.h"

#include <array>

#include "app/editor/bones.h"
#include "app/editor/command_parts.h"
#include "app/editor/handle_edits.h"
#include "app/editor/mirroring.h"
#include "app/editor/transport_commands.h"
#include "app/editor/turning.h"

namespace foldless {
namespace {

constexpr double kZoomStep = 1.25;

bool has_texture(const Editor& e) { return !e.document().texture.empty(); }
bool can_undo(const Editor& e) { return e.draft().is_editing() || e.draft().history().can_undo(); }
bool can_redo(const Editor& e) { return e.draft().history().can_redo(); }
bool is_diff_shown(const Editor& e) { return e.view().beside() == Beside::rest_mesh; }
bool are_poses_shown(const Editor& e) { return e.view().beside() == Beside::kept_pose; }
bool has_two_panes(const Editor& e) { return e.view().beside() != Beside::nothing; }
bool are_panes_linked(const Editor& e) {
  return has_two_panes(e) && e.view().side_pane().is_linked();
}
/// What was selected last goes: keys of the time line, or handles.
void delete_selected(Editor& e) {
  if (has_keys_selected(e))
    e.motion().keys().delete_selected();
  else
    e.edits().delete_selected();
}

template <Transformation What>
void begin(Editor& e) {
  begin_transformation(e, What);
}

template <std::size_t K>
void toggle_layer(Editor& e) {
  bool& shown = e.view().options().layers.*kLayerRows[K].shown;
  shown = !shown;
}

template <std::size_t K>
bool is_layer_on(const Editor& e) {
  return e.view().options().layers.*kLayerRows[K].shown;
}

void find_lost_work(Editor& e) {
  Recovery& recovery = e.files().recovery();
  recovery.find();
  if (!recovery.is_open() && recovery.unseen().empty())
    e.messages().toast(ToastKind::notice, "There is no unsaved work to recover");
}

void take_no_tool(Editor& e) {
  if (e.brush().is_on()) e.brush().toggle();
  if (e.bone_tool().is_on()) e.bone_tool().toggle();
}

/// One tool is in the hand at most.
template <auto Toggle>
void take_tool(Editor& e) {
  auto& tool = part_with(Toggle, e);
  const bool was_on = tool.is_on();
  take_no_tool(e);
  if (!was_on) tool.toggle();
}

/// The first time the pose on screen is kept: what is edited next is seen beside it.
void toggle_poses(Editor& e) {
  if (!e.comparison().kept()) e.comparison().keep();
  e.view().toggle_beside(Beside::kept_pose);
}

// A table reads best with one row a line.
// clang-format off

template <std::size_t K>
Command layer(std::string_view name) {
  const auto key = static_cast<Key>(static_cast<int>(Key::digit_1) + static_cast<int>(K));
  return in_race({name, "View", kLayerRows[K].title, {{key, kNone}}, always, toggle_layer<K>, is_layer_on<K>});
}

/// With Shift ten times, with Alt a tenth as far.
Command nudging(std::string_view name, std::string_view title, Key key, void (*run)(Editor&)) {
  return repeating({name, "Handles", title, {{key, kNone}, {key, kShift}, {key, kAlt}}, has_selection, run});
}

std::vector<Command> file_commands() {
  return {
      {"file.new", "File", "New", {{Key::n, kControl}}, always, call<&DocumentFiles::new_document>},
      {"file.open", "File", "Open\u2026", {{Key::o, kControl}}, always, ask<Request::open_dialog>},
      {"file.open_image", "File", "New from image\u2026", {}, always, ask<Request::image_dialog>},
      {"file.save", "File", "Save", {{Key::s, kControl}}, has_mesh, call<&DocumentFiles::save>},
      {"file.save_as", "File", "Save as\u2026", {{Key::s, kControlShift}}, has_mesh, ask<Request::save_dialog>},
      {"file.texture", "File", "Choose texture\u2026", {}, has_mesh, ask<Request::texture_dialog>},
      {"file.reload_texture", "File", "Reload picture", {}, has_texture, call<&DocumentFiles::reload_texture>},
      {"file.clear_texture", "File", "Remove texture", {}, has_texture, call<&DocumentFiles::clear_texture>},
      {"file.snapshot", "File", "Save picture", {{Key::f12, kNone}}, has_mesh, ask<Request::write_snapshot>},
      {"file.export", "File", "Export\u2026", {{Key::e, kControl}}, has_mesh, ask<Request::export_dialog>},
      {"file.export_again", "File", "Export again", {{Key::e, kControlShift}}, has_mesh, ask<Request::export_again>},
      in_race({"file.export_csv", "File", "Export convergence as CSV\u2026", {}, has_iterations, ask<Request::export_csv>}),
      in_race({"file.export_svg", "File", "Export convergence plots as SVG\u2026", {}, has_iterations, ask<Request::export_svg>}),
      in_race({"file.export_table", "File", "Export the race's table\u2026", {}, has_race, ask<Request::export_table>}),
      {"file.recover", "File", "Recover unsaved work\u2026", {}, always, find_lost_work},
      in_race({"file.quit", "File", "Quit", {{Key::q, kControl}}, always, call<&DocumentFiles::close>}),
  };
}

std::vector<Command> edit_commands() {
  return {
      repeating({"edit.undo", "Edit", "Undo", {{Key::z, kControl}}, can_undo, call<&Draft::undo>}),
      repeating({"edit.redo", "Edit", "Redo", {{Key::z, kControlShift}, {Key::y, kControl}}, can_redo, call<&Draft::redo>}),
      {"edit.delete", "Edit", "Delete handles or keys", {{Key::del, kNone}, {Key::backspace, kNone}}, [](const Editor& e) { return has_selection(e) || has_keys_selected(e); }, delete_selected},
      {"edit.reset_pose", "Edit", "Reset pose", {{Key::r, kControl}}, has_mesh, call<&DocumentEdits::reset_pose>},
      {"select.all", "Edit", "Select all", {{Key::a, kControl}}, has_handles, call<&Selection::select_all>},
      {"select.none", "Edit", "Select none", {{Key::a, kControlShift}}, has_selection, call<&Selection::select_none>},
      {"select.invert", "Edit", "Invert selection", {{Key::i, kControl}}, has_handles, call<&Selection::invert>},
      in_race({"edit.escape", "Edit", "Cancel, stop or deselect", {{Key::escape, kNone}}, always, call<&Editor::escape>}),
  };
}

std::vector<Command> handle_commands() {
  return {
      {"handle.pin", "Handles", "Pin or drag", {{Key::k, kNone}}, has_selection, toggle_pin},
      {"handle.turn", "Handles", "Turn", {{Key::r, kNone}}, has_selection, begin<Transformation::turn>},
      {"handle.scale", "Handles", "Scale", {{Key::s, kNone}}, has_several, begin<Transformation::scale>},
      nudging("handle.left", "Nudge left", Key::left, [](Editor& e) { nudge(e, {-1, 0}); }),
      nudging("handle.right", "Nudge right", Key::right, [](Editor& e) { nudge(e, {1, 0}); }),
      nudging("handle.up", "Nudge up", Key::up, [](Editor& e) { nudge(e, {0, 1}); }),
      nudging("handle.down", "Nudge down", Key::down, [](Editor& e) { nudge(e, {0, -1}); }),
      {"handle.move", "Handles", "Move handles", {{Key::v, kNone}}, has_mesh, take_no_tool, [](const Editor& e) { return !e.brush().is_on() && !e.bone_tool().is_on(); }},
      {"stiffness.paint", "Handles", "Paint stiffness", {{Key::b, kNone}}, has_mesh, take_tool<&StiffnessBrush::toggle>, [](const Editor& e) { return e.brush().is_on(); }},
      {"stiffness.clear", "Handles", "Remove all stiffness", {}, [](const Editor& e) { return e.brush().can_clear(); }, call<&StiffnessBrush::clear>},
      {"bones.draw", "Handles", "Draw bones", {{Key::n, kNone}}, has_mesh, take_tool<&BoneTool::toggle>, [](const Editor& e) { return e.bone_tool().is_on(); }},
      {"bones.make", "Handles", "Make bones", {{Key::j, kNone}}, can_make_bones, make_bones},
      {"bones.remove", "Handles", "Take bones apart", {{Key::j, kShift}}, can_take_bones_apart, take_bones_apart},
      {"mirror.toggle", "Handles", "Mirror", {{Key::x, kNone}}, has_mesh, toggle_mirror, is_mirror_on},
      {"mirror.pose", "Handles", "Pose mirrored", {{Key::x, kShift}}, has_selection, pose_mirrored},
      {"mirror.find", "Handles", "Find the mirror axis", {}, has_mesh, find_mirror_axis},
      {"mirror.upright", "Handles", "Upright mirror axis", {}, has_mesh, set_upright_mirror},
      {"mirror.level", "Handles", "Level mirror axis", {}, has_mesh, set_level_mirror},
      {"handle.forward", "Handles", "Bring forward", {{Key::right_bracket, kNone}}, has_selection, bring_forward},
      {"handle.back", "Handles", "Send back", {{Key::left_bracket, kNone}}, has_selection, send_back},
  };
}

std::vector<Command> view_commands() {
  return {
      repeating({"view.zoom_in", "View", "Zoom in", {{Key::plus, kNone}, {Key::plus, kShift}}, always, [](Editor& e) { e.view().zoom(kZoomStep); }}),
      repeating({"view.zoom_out", "View", "Zoom out", {{Key::minus, kNone}}, always, [](Editor& e) { e.view().zoom(1 / kZoomStep); }}),
      in_race({"view.fit", "View", "Fit all", {{Key::home, kNone}}, has_mesh, transport<&Race::fit, &CanvasView::fit_all>}),
      {"view.fit_selection", "View", "Fit selection", {{Key::f, kNone}}, has_mesh, call<&CanvasView::fit_selection>},
      {"view.fit_canvas", "View", "Fit the canvas", {}, [](const Editor& e) { return e.view().artboard().has_value(); }, call<&CanvasView::fit_artboard>},
      {"view.actual_size", "View", "100 %", {{Key::digit_0, kControl}}, always, call<&CanvasView::actual_size>},
      {"view.remesh_diff", "View", "Rest and deformed side by side", {{Key::d, kNone}}, has_mesh, [](Editor& e) { e.view().toggle_beside(Beside::rest_mesh); }, is_diff_shown},
      {"view.link_panes", "View", "Move both sides together", {{Key::d, kShift}}, has_two_panes, call<&CanvasView::toggle_link>, are_panes_linked},
      in_race({"view.mesh", "View", "Show the mesh", {{Key::tab, kNone}}, always, call<&CanvasView::toggle_mesh>, [](const Editor& e) { return e.view().is_mesh_shown(); }}),
      layer<0>("view.fill"),
      layer<1>("view.wireframe"),
      layer<2>("view.boundary"),
      layer<3>("view.heat"),
      layer<4>("view.handles"),
      layer<5>("view.remeshed"),
      layer<6>("view.rest"),
      in_race({"view.hide_overlays", "View", "Hide overlays while held", {{Key::h, kNone}}, always,
               [](Editor& e) { e.view().hide_overlays(true); },
               [](const Editor& e) { return e.view().are_overlays_hidden(); },
               [](Editor& e) { e.view().hide_overlays(false); }}),
      {"compare.hold", "View", "Rest or kept pose while held", {{Key::backslash, kNone}}, has_mesh,
       [](Editor& e) { e.comparison().hold(true); },
       [](const Editor& e) { return e.comparison().is_held(); },
       [](Editor& e) { e.comparison().hold(false); }},
      {"compare.keep", "View", "Keep this pose to compare with", {{Key::backslash, kShift}}, has_mesh, call<&PoseComparison::keep>},
      {"compare.side_by_side", "View", "Kept pose side by side", {{Key::backslash, kControl}}, has_mesh, toggle_poses, are_poses_shown},
      {"compare.forget", "View", "Forget the kept pose", {}, [](const Editor& e) { return e.comparison().kept() != nullptr; }, call<&PoseComparison::forget>},
      {"compare.outline", "View", "Outline of this pose, on or off", {{Key::o, kNone}}, has_mesh, call<&PoseComparison::toggle_outline>},
      {"compare.clear", "View", "Remove all outlines", {{Key::o, kShift}}, [](const Editor& e) { return e.comparison().has_outlines(); }, call<&PoseComparison::clear_outlines>},
      in_race({"help.search", "Help", "Search commands\u2026", {{Key::k, kControl}}, always, ask<Request::command_search>}),
      in_race({"help.keys", "Help", "Shortcuts", {{Key::f1, kNone}}, always, ask<Request::cheat_sheet>}),
  };
}

// clang-format on

}  // namespace

std::vector<Command> command_table() {
  std::vector<Command> table;
  for (const auto& part :
       {file_commands(), edit_commands(), handle_commands(), transport_commands(), view_commands()})
    table.insert(table.end(), part.begin(), part.end());
  return table;
}

}  // namespace foldless
