// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/export/gltf.h"
#include "app/export/held_steps.h"
#include "core/motion/bake.h"

namespace foldless {

/// Text files of a Spine skeleton.
struct SpineText {
  std::string json;   ///< the skeleton
  std::string atlas;  ///< names the pictures, see picture_name()
};

/// A baked animation as a skeleton of Spine 4.1 and later [Spine JSON format]: one bone at the
/// origin; for each piece a slot with a mesh attachment in the places of the first frame; and an
/// animation with a deform time line, one linear key a frame. Of a loop the first frame comes again
/// at the end. `animation`: as in_pixels() gives it; y is up here and there. `name`: of the
/// animation and its pictures. The pieces' pictures must not need to be repeated.
SpineText spine_text(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                     const std::string& name, const HeldSteps& held = {});

}  // namespace foldless
