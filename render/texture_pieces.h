// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/parts.h"
#include "render/camera.h"
#include "render/layered/layered_image.h"
#include "render/texture_levels.h"

namespace foldless {

/// A picture, or the layer of one, that fills a mesh or a part of it.
struct TexturePiece {
  std::shared_ptr<const TextureLevels> levels;  ///< null: nothing of the layer is seen
  /// Where it lies in the picture as a whole: (0, 0) is its lower left corner, (1, 1) its upper
  /// right one.
  Box within;
};

/// What a mesh is filled with: one picture, or a layer for each of its parts.
using TexturePieces = std::vector<TexturePiece>;

/// One picture for the whole mesh.
std::shared_ptr<const TexturePieces> whole_texture(Image image);

/// The layers of a painting by their names.
using LayerPieces = std::map<std::string, TexturePiece>;
LayerPieces layer_pieces(LayeredImage painting);

/// One for each part; nothing for parts whose layer is not there.
std::shared_ptr<const TexturePieces> pieces_for(const MeshParts& parts, const LayerPieces& layers);

/// A texture from a file, and what of it is missing, one sentence each.
struct LoadedTexture {
  std::shared_ptr<const TexturePieces> pieces;
  std::vector<std::string> notices;
};

/// Reads a file as the texture of a mesh with these parts (null: none): layer by layer where it has
/// layers, else as a whole. Throws Error as load_image() and load_layered().
LoadedTexture load_texture(const std::filesystem::path& file, const MeshParts* parts);

}  // namespace foldless
