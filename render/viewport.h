// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// A rectangle of the framebuffer in pixels, origin at its lower left corner as in glViewport.
struct Viewport {
  int x = 0;
  int y = 0;
  int width = 1;
  int height = 1;

  bool operator==(const Viewport&) const = default;
};

}  // namespace foldless
