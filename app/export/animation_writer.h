// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/export/animation_format.h"
#include "core/motion/bake.h"
#include "core/run/frames.h"
#include "core/run/frames_box.h"
#include "core/scene/scene.h"
#include "render/figure_options.h"
#include "render/image.h"

namespace foldless {

/// An animation whose frames are solved, and how it is to be written.
struct AnimationToWrite {
  std::filesystem::path output;
  AnimationFormat format;
  std::shared_ptr<const Scene> scene;
  std::filesystem::path scene_file;              ///< that it was read from; empty: none
  std::shared_ptr<const TexturePieces> texture;  ///< null: the checkerboard
  std::vector<SolvedFrame> solved;               ///< not empty
  bool loops = false;                            ///< they are all frames of a loop
  double fps = 24;                               ///< pictures a second
  std::optional<PictureSize> size;               ///< absent: size_for() of the box of all frames
  std::optional<Layers> layers;                  ///< absent: what a drawing is shown with
  FigureOptions figure;                          ///< theme and background
  ImageTexts texts = {};                         ///< see encode_png()
  double tolerance = 0.5;                        ///< of a bake [pixels]
  bool power_of_two = false;                     ///< sides of a sprite sheet
};

/// What pictures of it show.
FigureOptions figure_of(const AnimationToWrite& animation);

/// What a picture is drawn with, and who is told how far it is: may be called on any thread, and
/// draw nothing, which ends the writing.
struct AnimationMeans {
  std::function<std::optional<Image>(const Snapshot&)> draw;
  std::function<void(std::size_t done, std::size_t count)> progress;
};

/// Throws Error where the file would take the place of what it is made of: the scene file, its mesh
/// or its texture. To be asked before there are frames.
void expect_no_source(const AnimationToWrite& animation);

/// Leaves the frames from the first to the last of a range, from 0, which are no loop. To be done
/// when all are solved: a frame follows from those before it, and in a loop from the round that is
/// kept. Throws Error where there are fewer.
void keep_range(AnimationToWrite& animation, const std::array<int, 2>& range);

/// Writes an animation as pictures. False when the token was set or nothing was drawn; then
/// nothing is left of it. Throws Error. Precondition: the format is no baked one.
bool write_pictures(const AnimationToWrite& animation, const AnimationMeans& means,
                    const std::stop_token& token);

/// How a bake came out.
struct WrittenBake {
  BakedAnimation baked;
  std::vector<BakedFailure> failures;  ///< of the file as it holds it
  double deviation = 0;                ///< [pixels]

  bool is_good(double tolerance) const { return failures.empty() && deviation <= tolerance; }
};

/// Bakes an animation and writes it. Nothing when the token was set; then nothing was written.
/// Throws Error. Precondition: the format is a baked one.
std::optional<WrittenBake> write_bake(const AnimationToWrite& animation, const Frames& frames,
                                      const BakeProgress& progress, const std::stop_token& token);

}  // namespace foldless
