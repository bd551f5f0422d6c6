// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/fonts.h"
#include "app/gui/theme.h"

namespace foldless {

class Tooltips;

/// What every panel needs to draw itself.
struct Look {
  const Palette* palette = nullptr;
  Fonts fonts;
  float scale = 1;               ///< framebuffer pixels in one design pixel
  Tooltips* tooltips = nullptr;  ///< null: there are none

  /// A length in design pixels, in framebuffer pixels.
  float px(float design_pixels) const { return design_pixels * scale; }
};

}  // namespace foldless
