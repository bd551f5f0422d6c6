// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/export/animation_format.h"
#include "app/export/engine_mesh.h"
#include "core/files/file_group.h"
#include "core/motion/bake.h"

namespace foldless {

/// Files of a baked animation. What is proved is the animation as the file holds it, after its
/// numbers were rounded.
struct BakedFiles {
  std::string main;                ///< the bytes of the file that was asked for
  std::vector<NamedBytes> others;  ///< beside it
  std::vector<BakedFailure> failures;
};

/// What a baked animation looks like, and how large an engine has it.
struct BakedLook {
  std::vector<GltfPiece> pieces;  ///< not needed where the format is .foldless
  EngineUnits units;              ///< of Spine and Godot
};

/// The middle of the drawing's box is the origin; a pixel is one of the first piece's picture, or,
/// where that is repeated, makes the box 1024 pixels along its longer side.
EngineUnits engine_units(const Points& rest, const std::vector<GltfPiece>& pieces);

/// Makes them. Precondition: the format is a baked one. Throws Error.
BakedFiles baked_files(const std::filesystem::path& path, const AnimationFormat& format,
                       const BakedAnimation& animation, const BakedLook& look);

/// Writes them, the others together with the main one. Throws Error.
void write_baked(const std::filesystem::path& path, const BakedFiles& files);

}  // namespace foldless
