// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli_report.h"
#include "render/figure.h"

namespace foldless {

/// Makes a folder and those above it. Throws Error when it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// The folder that `solve` writes into. Every file is replaced as a whole.
class Results {
 public:
  /// Makes the folder and removes the frames and the picture of an earlier run from it. With
  /// `figure` there are pictures as well. Throws Error when the folder cannot be made or written
  /// to.
  Results(std::filesystem::path folder, const std::optional<FigureOptions>& figure);

  /// Writes the next of frames/000000.obj …: M′ with the rest positions as `vt`, and its picture.
  void add_frame(const Snapshot& snapshot);
  /// Writes rest.obj, deformed.obj, iterations.csv and report.json, and the picture deformed.png.
  void finish(const Solved& solved, const JsonNode& report);

 private:
  void draw(const Snapshot& snapshot, const FigureOptions& figure,
            const std::filesystem::path& picture);

  std::filesystem::path folder_;
  FigureOptions figure_;                      ///< of the result
  FigureOptions frame_figure_;                ///< of the frames
  std::unique_ptr<FigureRenderer> renderer_;  ///< null: no pictures
  int frames_ = 0;
};

}  // namespace foldless
