// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/image.h"

namespace foldless {

/// An image as the graphics card filters it: premultiplied, then each level half as wide and high
/// as the one before, down to one pixel. Made without the card, on any thread.
using TextureLevels = std::vector<Image>;

/// Every pixel of a level is the mean of what it covers. Empty for an empty image.
TextureLevels texture_levels(Image image);

}  // namespace foldless
