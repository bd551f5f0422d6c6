// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "render/layered/layered_image.h"

namespace foldless {

/// How much of a file is wanted.
enum class LayeredParts {
  merged,  ///< `merged`, and layers only where it is made of them
  all
};

/// By its first bytes: a zip archive, as OpenRaster and Krita write, or a Photoshop file.
bool is_layered(std::string_view bytes);

/// Reads the bytes of a file. Throws Error, without a file's name, as load_layered().
LayeredImage decode_layered(std::string_view bytes, LayeredParts parts);

class ZipArchive;

// One a format. They throw Error without a file's name.
LayeredImage decode_open_raster(const ZipArchive& archive, LayeredParts parts);
LayeredImage decode_krita(const ZipArchive& archive, LayeredParts parts);
LayeredImage decode_photoshop(std::string_view bytes);

}  // namespace foldless
