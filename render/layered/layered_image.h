// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/outline/alpha_map.h"
#include "render/image.h"

namespace foldless {

/// A layer of a painting, cut down to what of it is not transparent within the canvas.
struct PictureLayer {
  std::string name;  ///< no other layer of the file has it
  int x = 0;         ///< of its left column on the canvas, pixels
  int y = 0;         ///< of its uppermost row on the canvas, pixels from the top
  Image image;       ///< without the opacity; empty where nothing is seen, or hidden
  double opacity = 1;
  bool is_visible = true;  ///< and so is every group that holds it
};

/// A painting of several layers.
struct LayeredImage {
  int width = 0;   ///< of the canvas, pixels
  int height = 0;  ///< of the canvas, pixels
  /// Bottom to top; empty where the file has kinds of layers that only its merged picture shows.
  std::vector<PictureLayer> layers;
  Image merged;  ///< the painting as a whole, as large as the canvas
  /// What of the layers is not kept, one sentence each.
  std::vector<std::string> notices;
};

/// True for the names of such files: .ora, .kra and .psd in any case.
bool is_layered_file(const std::filesystem::path& file);

/// Reads an OpenRaster, Krita or Photoshop file; its first bytes tell which. Blend modes, masks and
/// the like are left out of the layers, with a notice. Throws Error when the file cannot be read,
/// is none of these or damaged, and where canvas or layers exceed the limits of load_image().
LayeredImage load_layered(const std::filesystem::path& file);

/// The alpha of the layers of which something is seen, bottom to top, without their opacities.
std::vector<LayerAlpha> layer_alphas(const LayeredImage& painting);

/// The layers over each other as they are painted: normal blending, visible ones only.
Image composed(const LayeredImage& painting);

}  // namespace foldless
