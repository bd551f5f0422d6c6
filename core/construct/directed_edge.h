// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace foldless {

/// The way from vertex a to vertex b as one number, by which maps find what is on its left.
inline std::uint64_t directed_edge(int a, int b) {
  return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
}

}  // namespace foldless
