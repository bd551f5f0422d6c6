// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/colormap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>

namespace foldless {
namespace {

/// 0xRRGGBB at equal steps from 0 to 1.
constexpr std::array<std::uint32_t, 20> kViridis{0x440154, 0x481568, 0x482677, 0x453781, 0x3F4788,
                                                 0x39558C, 0x32648E, 0x2D718E, 0x287D8E, 0x238A8D,
                                                 0x1F968B, 0x20A386, 0x29AF7F, 0x3CBC75, 0x56C667,
                                                 0x74D055, 0x94D840, 0xB8DE29, 0xDCE318, 0xFDE725};

glm::vec3 unpacked(std::uint32_t rgb) {
  return glm::vec3((rgb >> 16) & 255U, (rgb >> 8) & 255U, rgb & 255U) / 255.0F;
}

}  // namespace

glm::vec3 viridis(float t) {
  const float place = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  return glm::mix(unpacked(kViridis[below]), unpacked(kViridis[below + 1]),
                  place - static_cast<float>(below));
}

}  // namespace foldless
