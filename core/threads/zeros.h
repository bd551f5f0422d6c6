// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/threads/team.h"

namespace foldless {

/// An array of Eigen whose numbers are zero, of those sizes; threads share it, so that each has its
/// part in its cache.
template <class Array, class... Sizes>
Array zeros(Sizes... sizes) {
  constexpr std::ptrdiff_t kZerosTogether = 4096;  // as many as are worked on together
  Array array(sizes...);
  in_ranges(array.size(), kZerosTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::fill(array.data() + begin, array.data() + end, 0);
  });
  return array;
}

}  // namespace foldless
