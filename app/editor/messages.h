// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// What the editor wants its surroundings to do; they take it with Editor::take_requests().
enum class Request {
  open_dialog,   ///< ask for a file, then Editor::open
  image_dialog,  ///< ask for an image, then Editor::open
  save_dialog,  ///< ask for a path, then Editor::save_as or, when dismissed, Editor::answer(cancel)
  texture_dialog,  ///< ask for an image, then Editor::set_texture
  write_snapshot,  ///< a numbered PNG at once
  export_dialog,   ///< ask how to export
  export_again,    ///< export as last time
  export_csv,      ///< ask for a file, then write the iterations, the race's while there is one
  export_svg,      ///< ask for a file, then draw their convergence
  export_table,    ///< ask for a file, then write the race's table
  command_search,  ///< show the search over commands()
  cheat_sheet,     ///< show or hide the table of shortcuts
  quit             ///< nothing is unsaved, or the user said so: close the window
};

enum class ToastKind { notice, error };

/// A short message that goes away by itself.
struct Toast {
  int id = 0;
  ToastKind kind = ToastKind::notice;
  std::string text;  ///< one sentence
  double until = 0;  ///< when it goes away [s]
};

/// What waits for the question about unsaved changes.
enum class PendingKind { new_document, open, close };
struct PendingAction {
  PendingKind kind = PendingKind::new_document;
  std::filesystem::path path;  ///< to open
  bool is_sample = false;      ///< to be saved elsewhere
};
enum class Answer { save, discard, cancel };

enum class StatusKind { empty, ready, solving, converged, stopped, blocked, paused, failed };

/// What the solver does, in words: "Solving 12/1000", "Converged", "Blocked: …".
struct Status {
  StatusKind kind = StatusKind::empty;
  std::string words;
  double residual = 0;  ///< largest distance of a handle from its target [length]
};

/// A handle as it is drawn.
struct HandleView {
  int id = 0;
  int vertex = 0;
  HandleKind kind = HandleKind::drag;
  Vec2 position = Vec2::Zero();  ///< where it is
  Vec2 target = Vec2::Zero();    ///< where it should be
  double residual = 0;           ///< distance between the two [length]
  bool is_at_target = true;      ///< false: draw ring, line and distance
  bool is_selected = false;
  bool is_hovered = false;
};

}  // namespace foldless
