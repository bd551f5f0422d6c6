// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "core/scene/scene.h"
#include "core/snapshot.h"
#include "render/texture_pieces.h"

namespace foldless {

/// What a small picture of a file shows.
struct FileSketch {
  std::shared_ptr<const Snapshot> pose;        ///< of an image a rectangle; null: it cannot be read
  std::shared_ptr<const TexturePieces> image;  ///< null: there is none
  std::optional<TextureBox> image_box;         ///< absent: the box of the rest mesh
  std::shared_ptr<const MeshParts> parts;      ///< of the mesh; null: none
};

/// Reads a scene, a mesh or an image. Without a pose where that fails, or for a file so large that
/// a small picture is not worth it. On any thread.
FileSketch sketch_of(const std::filesystem::path& file);

}  // namespace foldless
