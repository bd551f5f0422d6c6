// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/motion/motion_proof.h"
#include "core/snapshot.h"

namespace foldless {

/// A frame of a baked animation.
struct BakedFrame {
  double frame = 0;  ///< the moment, in frames from the start
  Points deformed;   ///< 2 × #V
};

/// A moment at which a baked animation is not proved: `from` is the index of the frame before it.
struct BakedFailure {
  std::size_t from = 0;
  MotionFailure failure;
};

/// An animation on one mesh, for programs that move its vertices straight from frame to frame.
struct BakedAnimation {
  Triangles triangles;  ///< 3 × #F
  Points rest;          ///< 2 × #V, locally injective; the vertices of the drawing's mesh first
  int original_vertices = 0;
  std::vector<BakedFrame>
      frames;            ///< ascending; those between whole frames are there for the proof
  bool loops = false;    ///< the step from the last frame to the first counts too
  int cycle_frames = 0;  ///< frames of the animation
  double fps = 24;
  /// How far a point of the drawing is from where the solver has it at most, over all frames.
  double deviation = 0;  ///< [length]
};

/// Told what share of a bake is done, as far as can be known; in [0, 1], and never less than
/// before.
using BakeProgress = std::function<void(double)>;

/// What a bake is to keep to.
struct BakeOptions {
  double tolerance = 0;      ///< of the deviation [length]
  double vertex_limit = 32;  ///< most vertices, times those of the drawing
  BakeProgress progress = [](double) {};
};

/// The states between the frame of this number and the one after it that lead from one to the
/// other, as a solver went through them; nothing when the token was set. Those after the last frame
/// of a loop lead to the first.
using StatesBetween =
    std::function<std::optional<std::vector<std::shared_ptr<const Snapshot>>>(std::size_t)>;

/// The frames of an animation, solved on meshes of their own.
struct FramesToBake {
  Triangles original;  ///< the drawing's mesh, 3 × #F
  std::vector<double> moments;
  std::vector<std::shared_ptr<const Snapshot>> snapshots;  ///< one a moment
  bool loops = false;
  int cycle_frames = 0;
  double fps = 24;
};

/// Bakes frames onto one mesh: the drawing's, each of whose vertices is put where the frames' maps
/// take it. Where a triangle turns over or a point is further from the solver's than the tolerance,
/// the mesh gets the vertex or the crossing with the frame's edge at which it is furthest: with all
/// edges of all frames it would be exact, but few are needed. Where the way between two frames is
/// not proved, the state in the middle of those between them is baked as well, and so on; where the
/// states take half as many vertices again as the frames alone, those that lead to no proof are
/// left out. Returns nothing when the token was set.
std::optional<BakedAnimation> bake(const FramesToBake& frames, const BakeOptions& options,
                                   const StatesBetween& states_between,
                                   const std::stop_token& token);

/// Every step of a baked animation that is not proved; of each the first moment.
std::vector<BakedFailure> failures_of(const BakedAnimation& animation);

}  // namespace foldless
