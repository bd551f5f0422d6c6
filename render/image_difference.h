// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/image.h"

namespace foldless {

/// How two pictures of one size differ. The colour of what is transparent does not count: channels
/// are compared premultiplied.
struct ImageDifference {
  long long pixels = 0;  ///< that differ by more than the tolerance in a channel
  int largest = 0;       ///< of all channels and pixels [grey levels, 0 … 255]
  double mean = 0;       ///< likewise
  /// The box of those pixels, inclusive, y from the top; meaningless when there is none.
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Precondition: the pictures have one size. `tolerance` in grey levels.
ImageDifference difference_of(const Image& a, const Image& b, int tolerance);

/// The first picture in pale grey with the pixels that differ in red, the more the darker.
Image picture_of_difference(const Image& a, const Image& b, int tolerance);

}  // namespace foldless
