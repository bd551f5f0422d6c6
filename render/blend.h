// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/image.h"

namespace foldless {

/// Lays a colour (sRGB, straight alpha) over a pixel. Outside the image nothing happens.
inline void blend(Image& image, int x, int y, const glm::vec4& colour) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || colour.a <= 0) return;
  std::uint8_t* pixel = image.at(x, y);
  const float above = colour.a;
  const float below = static_cast<float>(pixel[3]) / 255 * (1 - above);
  const float alpha = above + below;
  if (alpha <= 0) return;
  for (int c = 0; c < 3; ++c) {
    const float mixed = (255 * colour[c] * above + static_cast<float>(pixel[c]) * below) / alpha;
    pixel[c] = static_cast<std::uint8_t>(std::lround(glm::clamp(mixed, 0.0F, 255.0F)));
  }
  pixel[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
}

}  // namespace foldless
