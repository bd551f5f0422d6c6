// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "render/layered/layered_image.h"

namespace foldless {

/// Pixels.
struct CanvasSize {
  int width, height;
};

/// The layer with the pixels of a layer file of Krita: a head of lines, then tiles of 64 × 64
/// pixels, each with a line of its own, `x,y,LZF,bytes`, blue, green, red and alpha one after the
/// other. Tiles count from the layer's place; where there is none, the default pixel stands. What
/// lies off the canvas is dropped. Throws Error when the file is damaged or of another kind.
PictureLayer with_tiles(std::string_view file, std::string_view default_pixel, PictureLayer layer,
                        const CanvasSize& canvas);

}  // namespace foldless
