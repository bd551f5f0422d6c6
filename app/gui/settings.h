// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "app/editor/keymap.h"
#include "app/gui/layout.h"
#include "render/view_options.h"

namespace foldless {

/// What the panels are for.
enum class Workspace {
  lab,     ///< studying mappings: solver, plots, iterations on the right
  animate  ///< posing drawings: one panel with handles and layers first
};

/// What the user set once for all documents.
struct Settings {
  double scale = 1;  ///< on top of the desktop's scale, 0.75 … 3
  Theme theme = Theme::dark;
  bool shows_panels = true;
  bool shows_artboard = true;  ///< the outline of a drawing's canvas
  bool shows_squares = false;  ///< grey ones, where a drawing is transparent
  bool shows_rulers = false;
  bool uses_desktop_dialogs = true;  ///< for files, where the desktop has them
  PanelWidths panel_widths;
  double time_line_height = kTimeLineHeight;  ///< of its keys [design pixels]
  /// Absent: never chosen, it goes by what is open.
  std::optional<Workspace> workspace;
  std::set<std::string> closed_sections;  ///< of the lab's panels, by title
  std::set<std::string> closed_in_animate{"Solver", "Convergence", "Iterations"};
  std::optional<double> pace;  ///< of the solver, see Playback::set_pace()
  /// Of meshes without a picture, when the program was left; absent: the defaults.
  std::optional<Layers> layers;
  int window_width = 1280, window_height = 800;  ///< window coordinates, while not maximised
  bool is_maximised = false;
  KeyChoice keys;
  std::string problem;           ///< what of the file is of no use, a sentence; empty: nothing
  double autosave_seconds = 60;  ///< how long a change may wait for its copy, 15 … 3600

  bool operator==(const Settings&) const = default;
};

inline constexpr double kSmallestScale = 0.75;
inline constexpr double kLargestScale = 3.0;

/// Where they are kept; empty when the folder is.
std::filesystem::path settings_file(const std::filesystem::path& state_folder);

/// Reads settings; what is missing or cannot be read takes its default.
Settings load_settings(const std::filesystem::path& file);

/// What save_settings() writes.
std::string settings_text(const Settings& settings);

/// Writes settings, and makes their folder if need be. Throws Error when that fails.
void save_settings(const std::filesystem::path& file, const Settings& settings);

}  // namespace foldless
