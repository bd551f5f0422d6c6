// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/input.h"
#include "app/gui/command_search.h"
#include "app/gui/context_menu.h"
#include "app/gui/export_dialog.h"
#include "app/gui/file_browser.h"
#include "app/gui/keys_dialog.h"
#include "app/gui/plot.h"
#include "app/gui/samples.h"
#include "app/gui/settings.h"
#include "app/gui/time_line.h"
#include "render/distortion.h"

namespace foldless {

inline constexpr int kNoFrame = -10;

/// The name of a handle while it is typed in its row.
struct NameField {
  int handle = 0;
  std::string text;
  bool is_new = true;  ///< it still needs the keyboard
};

/// What the panels remember from frame to frame and the document does not hold.
struct UiState {
  Settings settings;
  Workspace workspace = Workspace::lab;  ///< on screen
  std::vector<Sample> samples;
  FileBrowser browser;
  CommandSearch search;
  ExportDialog exporting;
  KeysDialog keys;
  ContextMenu context_menu;
  bool opens_cheat_sheet = false;
  bool shows_about = false;
  bool shows_log = false;
  bool wants_to_quit = false;
  std::string closed_description;  ///< of a scene: it is not shown again
  /// Which of convergence_series() the plots panel draws.
  std::array<bool, 8> shown_series{true, true, true};
  PlotZoom plot_zoom;                 ///< of all plots
  bool has_time_axis = false;         ///< plots over seconds of processor time, not over iterations
  std::filesystem::path last_folder;  ///< where the last file was opened or saved
  std::filesystem::path exported_to;  ///< the folder of the last export
  std::filesystem::path exported_from;  ///< the document's own folder then
  Modifiers modifiers;                  ///< held now
  std::optional<Vec2> pointer;          ///< on the canvas, framebuffer pixels
  TimeLineState time_line;
  std::string handle_search;             ///< in the list of handles
  std::optional<NameField> handle_name;  ///< that is typed in the list
  int handle_name_frame = kNoFrame;      ///< in which it was asked for
  std::optional<HeatRange> heat_range;   ///< of the heat map on screen
  std::optional<double> hovered_heat;    ///< its value under the pointer
};

}  // namespace foldless
