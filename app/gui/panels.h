// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/editor.h"
#include "app/gui/layout.h"
#include "app/gui/look.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// What a panel gets beside the editor.
struct PanelContext {
  UiState& state;
  const Look& look;
  const Layout& layout;
};

// Each draws one part of the window inside an ImGui frame and changes the editor as the user asks.

void draw_menu_bar(Editor& editor, const PanelContext& context);
/// A narrow column of icons: what one does most.
void draw_tool_strip(Editor& editor, const PanelContext& context);
/// Both side panels with their sections, or the one of a narrow window.
void draw_side_panels(Editor& editor, const PanelContext& context);
/// Lets the side panels be made wider by their edges; a double click makes one as it was at first.
void draw_panel_edges(const PanelContext& context);
/// Run, pause, step, stop, pace, and the scrubber over the iterations.
void draw_timeline_panel(Editor& editor, const PanelContext& context);
/// Hints of what the mouse does now, the status in words, and the proof badge.
void draw_status_bar(Editor& editor, const PanelContext& context);
/// Coordinates along the borders of the canvas, and where the pointer is on them.
void draw_rulers(const Editor& editor, const PanelContext& context);
/// The outline of the canvas that a drawing was painted on.
void draw_artboard(const Editor& editor, const PanelContext& context);
/// The pane beside the canvas, and what both are.
void draw_side_panes(Editor& editor, const PanelContext& context);
/// What stands in the way of handles that do not get to their targets, and what helps.
void draw_stuck_card(Editor& editor, const PanelContext& context);
/// Lanes, plots and table of the race, over everything between menu and timeline.
void draw_race_panel(Editor& editor, const PanelContext& context);
void draw_toasts(Editor& editor, const PanelContext& context);
/// Everything that covers the rest: files, export, search, cheat sheet, questions.
void draw_dialogs(Editor& editor, const PanelContext& context);

// Sections of the side panels.

void draw_layers_panel(Editor& editor, const PanelContext& context);
void draw_handles_panel(Editor& editor, const PanelContext& context);
/// What the selected handles have, as fields.
void draw_handle_inspector(Editor& editor, const PanelContext& context);
/// The stiffness brush: what it paints with.
void draw_stiffness_panel(Editor& editor, const PanelContext& context);
void draw_history_panel(Editor& editor, const PanelContext& context);
void draw_solver_panel(Editor& editor, const PanelContext& context);
void draw_plots_panel(Editor& editor, const PanelContext& context);
void draw_iterations_panel(Editor& editor, const PanelContext& context);

// Dialogs.

void draw_cheat_sheet(Editor& editor, const PanelContext& context);
/// All messages that were shown, as text that can be copied.
void draw_message_log(Editor& editor, const PanelContext& context);
void draw_about(const PanelContext& context);
void draw_unsaved_question(Editor& editor, const PanelContext& context);
void draw_overwrite_question(Editor& editor, const PanelContext& context);

}  // namespace foldless
