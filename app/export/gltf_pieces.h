// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/export/gltf.h"
#include "core/scene/scene.h"
#include "render/texture_pieces.h"

namespace foldless {

/// What the triangles of a scene's baked animation show: its texture, layer by layer where it has
/// parts, or the checkerboard where `texture` is null.
std::vector<GltfPiece> gltf_pieces(const Scene& scene, const BakedAnimation& animation,
                                   const std::shared_ptr<const TexturePieces>& texture);

}  // namespace foldless
