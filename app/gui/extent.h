// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// A size in whole units: window coordinates or framebuffer pixels, the user says which.
struct Extent {
  int width = 0;
  int height = 0;

  bool operator==(const Extent&) const = default;
};

/// The pointer's shape.
enum class CursorShape { arrow, text, hand, resize, resize_height };

}  // namespace foldless
