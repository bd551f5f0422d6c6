// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/export/held_steps.h"
#include "core/motion/bake.h"
#include "render/camera.h"
#include "render/image.h"

namespace foldless {

/// Triangles of a baked animation that show one picture.
struct GltfPiece {
  std::vector<int> triangles;  ///< ascending
  Image image;
  Box place;  ///< of the picture in the rest plane, its lower left and upper right corner
  bool is_tiled = false;  ///< the picture is repeated beyond its place, with hard pixels
  double z = 0;           ///< the larger is in front [length]
};

/// A baked animation as a binary glTF 2.0 file (.glb) [glTF]: the mesh of its first frame in the
/// plane z = 0, a morph target for each later one, and an animation of their weights, LINEAR, so
/// that viewers move vertices straight from frame to frame. Of a loop the first frame comes again
/// at the end. Pictures are shown as they are, without light. Throws Error when it would be larger
/// than the format allows.
std::string gltf_binary(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                        const HeldSteps& held = {});

/// The animation as glTF holds it, in single precision: first frame and differences to it. What is
/// to be proved of a file is to be proved of this.
BakedAnimation in_single_precision(const BakedAnimation& animation);

}  // namespace foldless
