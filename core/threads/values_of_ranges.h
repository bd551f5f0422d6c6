// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/threads/team.h"

namespace foldless {

/// of(begin, end) for the ranges that make up 0 … count, each of `grain` but the last, in their
/// order. The ranges are the same however many threads share them, so that what is summed up from
/// their values has the same bits.
template <class Of>
auto values_of_ranges(std::ptrdiff_t count, std::ptrdiff_t grain, const Of& of) {
  std::vector<decltype(of(count, count))> values(
      static_cast<std::size_t>((count + grain - 1) / grain));
  in_parallel(static_cast<int>(values.size()), [&](int i) {
    const std::ptrdiff_t begin = i * grain;
    values[static_cast<std::size_t>(i)] = of(begin, std::min(begin + grain, count));
  });
  return values;
}

/// What of(begin, end) lists, one after the other.
template <class Of>
auto joined_ranges(std::ptrdiff_t count, std::ptrdiff_t grain, const Of& of) {
  decltype(of(count, count)) all;
  for (const auto& own : values_of_ranges(count, grain, of))
    all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace foldless
