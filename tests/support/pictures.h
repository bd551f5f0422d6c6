// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "render/image.h"
#include "tests/support/alpha_maps.h"

namespace foldless::test {

/// A picture with this alpha and smooth colours that differ everywhere.
inline Image painted(const AlphaMap& alpha) {
  Image image(alpha.width, alpha.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y)[0] = static_cast<std::uint8_t>(255 * x / image.width);
      image.at(x, y)[1] = static_cast<std::uint8_t>(255 * y / image.height);
      image.at(x, y)[2] = static_cast<std::uint8_t>(40 + 20 * ((x / 8 + y / 8) % 2));
      image.at(x, y)[3] = alpha.at(x, y);
    }
  return image;
}

/// Writes a painted ring with a disk in its middle; see ring_map().
inline void write_ring(const std::filesystem::path& file, int side) {
  save_png(file, painted(ring_map(side)));
}

}  // namespace foldless::test
