// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace foldless {

/// How opaque the pixels of a picture are: 0 transparent … 255 opaque, rows from the top.
struct AlphaMap {
  int width = 0;                     ///< pixels
  int height = 0;                    ///< pixels
  std::vector<std::uint8_t> values;  ///< width × height

  std::uint8_t at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// How opaque a layer of a painting is, and where it lies.
struct LayerAlpha {
  std::string name;
  int x = 0;  ///< of its left column on the canvas, pixels
  int y = 0;  ///< of its uppermost row on the canvas, pixels from the top
  AlphaMap alpha;
};

}  // namespace foldless
