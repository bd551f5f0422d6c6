// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/report.h"
#include "app/cli/result_folder.h"
#include "render/figure.h"

namespace foldless {

/// What `solve` writes: all of it, in the place of an earlier result, or nothing.
class Results {
 public:
  /// With `figure` there are pictures as well. Throws Error when the folder cannot be written to,
  /// or has files under the names that are needed that `solve` did not write.
  Results(std::filesystem::path folder, bool has_frames,
          const std::optional<FigureOptions>& figure);

  /// Adds the next of frames/000000.obj …: M′ with the rest positions as `vt`, and its picture.
  void add_frame(const Snapshot& snapshot);
  /// Adds rest.obj, deformed.obj, iterations.csv and report.json, and the picture deformed.png, and
  /// puts everything in its place.
  void finish(const Solved& solved, const JsonNode& report);

 private:
  /// An error in a task is not about files of the folder in which it is staged.
  template <typename Task>
  void told_by_final_names(const Task& task);
  void stage_frame(const Snapshot& snapshot);
  void stage_rest(const Solved& solved, const JsonNode& report);
  void draw(const Snapshot& snapshot, const FigureOptions& figure,
            const std::filesystem::path& picture);

  std::unique_ptr<FigureRenderer> renderer_;  ///< null: no pictures
  ResultFolder folder_;
  FigureOptions figure_;        ///< of the result
  FigureOptions frame_figure_;  ///< of the frames
  int frames_ = 0;
};

}  // namespace foldless
