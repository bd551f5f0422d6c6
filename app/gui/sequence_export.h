// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor.h"
#include "app/gui/canvas_picture.h"
#include "core/run/latest_job.h"

namespace foldless {

/// The iterations since the last edit as numbered pictures in a folder of their own: one is drawn a
/// frame, and encoded and written on a thread, so that the window stays alive. Every function needs
/// the GL context that was current in start().
class SequenceExport {
 public:
  SequenceExport() = default;
  /// What is not finished is taken away.
  ~SequenceExport();
  SequenceExport(const SequenceExport&) = delete;
  SequenceExport& operator=(const SequenceExport&) = delete;

  /// Begins with the view and the iterations of now; what the user does later changes nothing.
  /// Throws Error when there are no iterations, the folder is there already or cannot be made, or
  /// while another sequence is being written.
  void start(const std::filesystem::path& folder, Editor& editor, const PictureOptions& options);
  /// Draws the next picture when the last one is written, and says so at the end. Leaves another
  /// framebuffer bound.
  void update(Editor& editor, double time);
  /// The next update() takes away what was written, once no picture is being written.
  void cancel() { is_cancelled_ = true; }

  bool is_busy() const { return job_.has_value(); }
  std::size_t written() const { return written_; }
  std::size_t count() const { return job_ ? job_->snapshots.size() : 0; }
  /// Seconds until the end at the pace so far; nothing while nobody can know.
  std::optional<double> seconds_left() const;

 private:
  /// All that the pictures are made of.
  struct Job {
    std::filesystem::path folder;
    std::vector<std::shared_ptr<const Snapshot>> snapshots;
    PictureSetting setting;
    const Density* energy;
    ImageTexts texts;
    std::unique_ptr<SceneRenderer> renderer;
  };

  void draw_next();
  void end(Editor& editor, const std::string& problem);
  void take_away() const;

  std::optional<Job> job_;
  std::size_t written_ = 0;
  bool is_writing_ = false;
  bool is_cancelled_ = false;
  std::optional<double> first_time_;
  double time_ = 0;
  std::mutex mutex_;                    ///< of what follows
  std::optional<std::string> problem_;  ///< of a picture that was written; empty: none
  std::unique_ptr<LatestJob> writer_;
};

}  // namespace foldless
