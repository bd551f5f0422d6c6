// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/export/gltf.h"
#include "app/export/held_steps.h"
#include "core/motion/bake.h"

namespace foldless {

/// A baked animation as a scene of Godot 4 (.tscn): for each piece a Polygon2D with its triangles,
/// and an AnimationPlayer whose animation moves their `polygon`, one linear key a frame, in a loop
/// where it is one; then the first frame comes again at the end. `animation`: as in_pixels() gives
/// it, y up; the scene's y is down. `name`: of the scene, its animation and its pictures, see
/// picture_name(), which are looked for beside it. The pieces' pictures must not need to be
/// repeated.
std::string godot_scene(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                        const std::string& name, const HeldSteps& held = {});

}  // namespace foldless
