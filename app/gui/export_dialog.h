// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/animation_options.h"
#include "app/gui/export_job.h"
#include "app/gui/look.h"

namespace foldless {

struct UiState;

/// Ctrl+E: asks for the format and its options, then for a file. The job is taken by whoever can
/// carry it out.
class ExportDialog {
 public:
  void open(const Editor& editor);
  /// The last export once more, or the dialog when there was none.
  void repeat(const Editor& editor);
  void draw(Editor& editor, UiState& state, const Look& look);

  /// Asks for a job to be done, as F12 does without a dialog.
  void order(ExportJob job) { ordered_ = std::move(job); }
  std::optional<ExportJob> take_order();

 private:
  void draw_picture_options(const Editor& editor, const Look& look);
  void draw_free_size(const Editor& editor, const Look& look);
  void draw_options(const Editor& editor, const Look& look);
  void draw_animation_row(const Editor& editor, const Look& look);
  bool is_animation() const;
  void ask_for_file(Editor& editor, UiState& state);

  int format_ = 0;  ///< row of the formats, or one more: an animation
  AnimationOptions animation_;
  ExportJob job_;
  /// What the user chose; until then a drawing is written with its transparency.
  std::optional<bool> is_transparent_;
  std::optional<ExportJob> last_;
  std::optional<ExportJob> ordered_;
  bool opens_now_ = false;
};

}  // namespace foldless
