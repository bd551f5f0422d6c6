// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "app/editor/editor.h"
#include "app/export/animation_writer.h"
#include "core/run/latest_job.h"
#include "core/run/solved_animation.h"
#include "render/figure.h"

namespace foldless {

/// How an animation is written, as the dialog asks.
struct AnimationChoice {
  AnimationFormat format;
  std::optional<PictureSize> size;  ///< absent: 1024 pixels along the longer side
  std::optional<double> fps;        ///< pictures a second; absent: those of the animation
  bool is_transparent = false;
  double tolerance = 0.5;                        ///< of a bake [pixels]
  std::optional<std::array<int, 2>> range = {};  ///< first and last frame; absent: all
  bool power_of_two = false;                     ///< sides of a sprite sheet
};

/// The animation of a document as a file of its own, written as `foldless animate` does, on a
/// thread; only pictures are drawn by update(), as the window's context belongs to its thread.
/// Every function needs the GL context that was current in start().
class AnimationExport {
 public:
  enum class Stage { solving, second_round, drawing, baking };

  AnimationExport() = default;
  ~AnimationExport();  ///< cancels
  AnimationExport(const AnimationExport&) = delete;
  AnimationExport& operator=(const AnimationExport&) = delete;

  /// Begins with the document of now; what the user does later changes nothing. Throws Error when
  /// there is no animation, or the file would take the place of what it is made of, or while
  /// another is being written.
  void start(const std::filesystem::path& path, Editor& editor, const AnimationChoice& choice);
  /// Draws the picture that is waited for, and says so at the end. Leaves another framebuffer
  /// bound.
  void update(Editor& editor, double time);
  /// A later update() says so; nothing is left of the file.
  void cancel() { stop_.request_stop(); }

  bool is_busy() const { return is_busy_; }
  /// `Solving: 3 of 24 frames, 2 s left`.
  std::string progress_words() const;
  /// In [0, 1]; nothing where nobody can know.
  std::optional<float> share() const;

 private:
  struct Job {
    AnimationToWrite animation;
    Frames frames;
    std::vector<double> moments;  ///< to be solved; empty: they are
    double closing_tolerance = 0;
    std::optional<std::array<int, 2>> range;  ///< of the frames
  };
  struct Progress {
    Stage stage = Stage::solving;
    std::size_t done = 0, count = 0;
  };
  /// How it ended.
  struct End {
    ToastKind kind = ToastKind::notice;
    std::string words;
  };

  End write(Job& job);
  End write_job(Job& job);
  std::optional<Image> ask_for(const Snapshot& snapshot, const FigureOptions& figure);
  void draw();
  void tell(Stage stage, std::size_t done, std::size_t count);

  bool is_busy_ = false;
  std::unique_ptr<FigureRenderer> renderer_;
  std::optional<double> stage_began_;
  Progress seen_;
  double time_ = 0;
  std::stop_source stop_;

  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable_any is_drawn_;
  const Snapshot* wanted_ = nullptr;  ///< to be drawn
  const FigureOptions* figure_ = nullptr;
  std::optional<Image> drawn_;
  std::string problem_;  ///< of drawing
  Progress progress_;
  std::optional<End> end_;
  LatestJob thread_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
