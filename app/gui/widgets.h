// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>

#include "app/gui/icons.h"
#include "app/gui/look.h"

namespace foldless {

/// A square button with a picture.
struct IconButton {
  const char* id;
  Icon icon;
  std::string tip;         ///< the tooltip
  bool is_main = false;    ///< the one that people look for; filled
  bool is_chosen = false;  ///< a switch that is on, a tool that is in the hand; tinted
};

/// Draws it; true when it is pressed.
bool icon_button(const IconButton& button, const Look& look);

/// A button in the accent colour: the one thing a dialog is for.
bool main_button(const char* label, const Look& look);

/// A heading that folds its section away, or opens it; returns whether it is open now.
bool section(const char* title, bool is_open, const Look& look);

/// The name of what is chosen in the control beside it, with a dot before it where that was
/// changed; the others leave room for the dot.
void label_of_choice(std::string_view words, bool is_changed, const Look& look);

/// One line of secondary text, cut at the end when it does not fit.
void dim_text(const std::string& text, const Look& look);

/// Shows wrapped text beside the panel when the mouse has rested on the last item.
void tooltip(const std::string& text, const Look& look);

/// A key cap, `Ctrl+Z`, at the cursor.
void key_cap(const std::string& key, const Look& look);

/// Places the next window in the middle, at most `size` design pixels and always inside.
void centre_next_window(const ImVec2& size, const Look& look);

/// Opens a modal dialog's window in the middle: `size` design pixels, or as large as its content
/// when absent. When true, end_dialog() must follow.
bool begin_dialog(const char* id, const Look& look, std::optional<ImVec2> size = std::nullopt);
void end_dialog();

/// A large heading.
void title_text(const char* words, const Look& look);

/// Begins a part that scrolls where the window is low, with room for the outlines of controls.
/// Always followed by ImGui::EndChild().
void begin_controls(const char* id, const ImVec2& size, const Look& look);

/// Begins a list whose rows ImGui highlights from edge to edge, with room round them. Always
/// followed by ImGui::EndChild().
void begin_rows(const ImVec2& size, const Look& look);
/// The height that so many rows of text need in it.
float rows_height(std::size_t rows, const Look& look);

/// ImGui::BeginCombo() whose choice is shortened where it has no room.
bool begin_combo(const char* id, const std::string& choice, ImGuiComboFlags flags = 0);

/// Draws how far a slider stands, 0 … 1, as a line at the bottom of the last item, which leaves its
/// number readable.
void slider_line(double position, const Look& look);

}  // namespace foldless
