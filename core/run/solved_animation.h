// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/run/solved_before.h"

namespace foldless {

/// All frames of an animation, solved one after the other.
struct SolvedAnimation {
  std::vector<SolvedFrame> frames;
  /// Of a loop: how far a vertex of the drawing is from its first place when the loop begins anew,
  /// at most. [length]
  double gap = 0;
};

/// Told how many frames of how many are solved, and in which round: 2 where a loop is gone through
/// once more.
using FrameProgress = std::function<void(std::size_t, std::size_t, int)>;

/// What is to be solved of an animation.
struct FramesWanted {
  std::vector<double> moments;  ///< ascending, in frames from the start
  double tolerance = 0;         ///< of the gap of a loop [length]
  FrameProgress progress = [](std::size_t, std::size_t, int) {};
  std::vector<SolvedFrame> known = {};  ///< the first of them, solved before in a first round
  /// What was solved from the same mesh at rest with the same parameters; gets what is solved now.
  /// Null: nothing.
  std::shared_ptr<SolvedBefore> before = nullptr;
  /// Told each that is solved in the first round.
  std::function<void(const SolvedFrame&)> first_round = [](const SolvedFrame&) {};
};

/// Solves an animation. A loop that does not come back to its first shape within the tolerance is
/// gone through once more from where it came to, and the round that closes better is kept. Nothing
/// when the token was set.
std::optional<SolvedAnimation> solve_animation(const Frames& frames, const FramesWanted& wanted,
                                               const std::stop_token& token);

/// A pixel of a picture of the usual size, 1024 along the longer side of the drawing. [length]
double usual_pixel(const Points& rest);

/// How far a loop may be from its first shape: a quarter of a usual pixel. [length]
double closing_tolerance(const Points& rest);

/// The moments at which an animation is seen with so many frames a second.
std::vector<double> moments_of(const Animation& animation, double fps);

}  // namespace foldless
