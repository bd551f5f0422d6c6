// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/theme.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace foldless {
namespace {

/// 0xRRGGBB and an opacity.
constexpr glm::vec4 rgb(std::uint32_t hex, float alpha = 1) {
  return {static_cast<float>((hex >> 16) & 255U) / 255.0F,
          static_cast<float>((hex >> 8) & 255U) / 255.0F, static_cast<float>(hex & 255U) / 255.0F,
          alpha};
}

constexpr CanvasColours kDark{
    .background = rgb(0x17191D),
    .checker_light = rgb(0xE8E4DA),
    .checker_dark = rgb(0x6F8FAF),
    .wire = rgb(0x10151C, 0.42F),
    .boundary = rgb(0x0B0E12),
    .rest = rgb(0xAEB8C6, 0.75F),
    .handle = rgb(0x2EB872),
    .handle_rim = rgb(0xFFFFFF),
    .selected = rgb(0x35D0FF),
    .hovered = rgb(0xFFFFFF, 0.35F),
    .target = rgb(0xFF5A5F),
    .flipped = rgb(0x1D5BFF),
    .casing = rgb(0xFFFFFF, 0.8F),
    .folded = rgb(0xFFD500),
    .split = rgb(0xFF9417),
    .text = rgb(0xE6E9EE),
};

constexpr CanvasColours kLight{
    .background = rgb(0xF3F4F6),
    .checker_light = rgb(0xFFFFFF),
    .checker_dark = rgb(0x9DB7D3),
    .wire = rgb(0x1F2A37, 0.38F),
    .boundary = rgb(0x1F2A37),
    .rest = rgb(0x6B7686, 0.75F),
    .handle = rgb(0x17A45C),
    .handle_rim = rgb(0xFFFFFF),
    .selected = rgb(0x0A84FF),
    .hovered = rgb(0x0A84FF, 0.25F),
    .target = rgb(0xE5383B),
    .flipped = rgb(0x1549E0),
    .casing = rgb(0xFFFFFF, 0.8F),
    .folded = rgb(0xFFCC00),
    .split = rgb(0xF07C00),
    .text = rgb(0x1F2A37),
};

constexpr CanvasColours kContrast{
    .background = rgb(0x000000),
    .checker_light = rgb(0xFFFFFF),
    .checker_dark = rgb(0x7A7A7A),
    .wire = rgb(0x000000, 0.85F),
    .boundary = rgb(0xFFFF00),
    .rest = rgb(0xFFFFFF),
    .handle = rgb(0x00E676),
    .handle_rim = rgb(0x000000),
    .selected = rgb(0x00E5FF),
    .hovered = rgb(0xFFFF00, 0.6F),
    .target = rgb(0xFF3D3D),
    .flipped = rgb(0x0037FF),
    .casing = rgb(0xFFFFFF, 0.8F),
    .folded = rgb(0xFFFF00),
    .split = rgb(0xFF8A00),
    .text = rgb(0xFFFFFF),
};

}  // namespace

const CanvasColours& canvas_colours(Theme theme) {
  static constexpr std::array<const CanvasColours*, 3> kThemes{&kDark, &kLight, &kContrast};
  return *kThemes[static_cast<std::size_t>(theme)];
}

}  // namespace foldless
