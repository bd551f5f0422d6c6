// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/export/gltf.h"
#include "core/motion/bake.h"

namespace foldless {

/// Lengths of a drawing as pixels of a game engine.
struct EngineUnits {
  Vec2 origin = Vec2::Zero();  ///< of the drawing, where the engine has its own [length]
  double pixel = 1;            ///< [length]
};

/// The animation in pixels from the origin, y up, as the files for game engines hold it: every
/// coordinate is rounded to a multiple of one power of 2 that is coarse enough for coordinates and
/// their differences to be exact in single precision, and at most 2⁻²² of the largest
/// coordinate. So decimal digits, differences to the first frame and an engine's single precision
/// lose nothing more, and what is proved of this is proved of the file.
BakedAnimation in_pixels(const BakedAnimation& animation, const EngineUnits& units);

/// The triangles of a piece with vertices of their own.
struct EngineMesh {
  std::vector<int> vertices;  ///< of the animation; those of the hull first
  int hull = 0;               ///< vertices of the boundary loop that is longest, in its order
  Triangles triangles;        ///< 3 × #F, into `vertices`, in the order of the piece
  std::vector<Edge> edges;    ///< likewise, ascending
};
EngineMesh engine_mesh(const BakedAnimation& animation, const std::vector<int>& triangles);

/// The piece with a picture that need not be repeated, for programs that cannot.
GltfPiece without_tiles(const BakedAnimation& animation, const GltfPiece& piece);

/// When each key is, from the first on: one a frame, and of a loop one more at its end. [s]
std::vector<double> key_times(const BakedAnimation& animation);
/// The frame of a key: that after the last of a loop is the first again.
const Points& frame_of_key(const BakedAnimation& animation, std::size_t key);

/// `NAME.png`, or `NAME-2.png` and so on where there are several pieces; `piece` from 0.
std::string picture_name(const std::string& name, std::size_t piece, std::size_t pieces);

}  // namespace foldless
