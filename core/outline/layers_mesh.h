// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/mesh/parts.h"
#include "core/outline/image_mesh.h"

namespace foldless {

/// The mesh of a painting, layer by layer; parts overlap where layers do.
struct LayersMesh {
  ImageMesh mesh;
  MeshParts parts;                    ///< as the layers, and with greater and greater depths
  std::vector<std::string> left_out;  ///< layers in which nothing is opaque enough
};

/// As opaque as the most opaque layer at every pixel: for options_for(). `canvas` is its size, and
/// layers lie within it.
AlphaMap united(std::span<const LayerAlpha> layers, const Vec2& canvas);

/// Meshes each layer, bottom to top, as mesh_of_image() does the whole; `canvas` is its size.
/// Layers lie within it. Nothing if `stop` was requested before it was done. Throws Error as
/// mesh_of_image().
std::optional<LayersMesh> mesh_of_layers(std::span<const LayerAlpha> layers, const Vec2& canvas,
                                         const ImageMeshOptions& options,
                                         const std::stop_token& stop = {});

}  // namespace foldless
