// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace foldless {
namespace {

/// Filtering straight alpha would bring in the colour of transparent pixels: a dark or bright seam.
Image premultiplied(Image image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4)
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[p + c] =
          static_cast<std::uint8_t>((image.pixels[p + c] * image.pixels[p + 3] + 127) / 255);
  return image;
}

/// How much each of the three pixels from 2 · i on counts for pixel i of a row half as long.
std::array<float, 3> weights_at(int i, int length) {
  if (length == 1) return {1, 0, 0};
  if (length % 2 == 0) return {0.5F, 0.5F, 0};
  const int half_length = length / 2;
  const auto half = static_cast<float>(half_length), whole = static_cast<float>(length);
  const auto before = static_cast<float>(i);
  return {(half - before) / whole, half / whole, (before + 1) / whole};
}

Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    const auto down = weights_at(y, image.height);
    for (int x = 0; x < half.width; ++x) {
      const auto across = weights_at(x, image.width);
      std::array<float, 4> sum{0.5F, 0.5F, 0.5F, 0.5F};  // to the nearest
      for (int v = 0; v < 3; ++v)
        for (int u = 0; u < 3; ++u) {
          const float weight =
              down[static_cast<std::size_t>(v)] * across[static_cast<std::size_t>(u)];
          if (weight == 0) continue;
          const std::uint8_t* pixel = image.at(2 * x + u, 2 * y + v);
          for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<float>(pixel[c]);
        }
      for (std::size_t c = 0; c < 4; ++c) half.at(x, y)[c] = static_cast<std::uint8_t>(sum[c]);
    }
  }
  return half;
}

}  // namespace

TextureLevels texture_levels(Image image) {
  TextureLevels levels;
  if (image.width < 1 || image.height < 1) return levels;
  levels.push_back(premultiplied(std::move(image)));
  while (levels.back().width > 1 || levels.back().height > 1) {
    Image next = halved(levels.back());
    levels.push_back(std::move(next));
  }
  return levels;
}

}  // namespace foldless
