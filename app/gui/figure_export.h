// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/canvas_picture.h"
#include "core/run/latest_job.h"

namespace foldless {

/// The canvas as an SVG or PDF file, drawn and written on a thread of its own while the user goes
/// on.
class FigureExport {
 public:
  /// Begins with what is on screen now. Throws Error when there is no mesh, or while it still
  /// writes another.
  void start(const std::filesystem::path& path, const Editor& editor,
             const PictureOptions& options);
  /// Says what became of it when it is done.
  void update(Editor& editor);
  bool is_busy() const { return is_busy_; }

 private:
  bool is_busy_ = false;
  std::filesystem::path path_;
  std::mutex mutex_;                    ///< of what follows
  std::optional<std::string> problem_;  ///< of a job that ended; empty: it has written the file
  LatestJob job_;                       ///< the last member: it ends before what it uses
};

}  // namespace foldless
