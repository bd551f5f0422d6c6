// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "core/outline/alpha_map.h"

namespace foldless::test {

inline AlphaMap opaque_map(int width, int height) {
  AlphaMap map{width, height, {}};
  map.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  return map;
}

/// Alpha by a function of a pixel's centre, x to the right and y down, in 0 … 1.
template <typename Function>
AlphaMap alpha_map(int width, int height, const Function& alpha) {
  AlphaMap map = opaque_map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.values[static_cast<std::size_t>(y * width + x)] = static_cast<std::uint8_t>(
          std::lround(255 * std::clamp(static_cast<double>(alpha(x + 0.5, y + 0.5)), 0.0, 1.0)));
  return map;
}

/// One character a pixel, rows of equal length: a space is transparent, all else opaque.
inline AlphaMap drawn_map(const std::vector<std::string_view>& rows) {
  return alpha_map(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()),
                   [&](double x, double y) {
                     return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] != ' ';
                   });
}

/// A ring with soft edges in the middle of a square picture, and a disk in the middle of the ring.
inline AlphaMap ring_map(int side) {
  return alpha_map(side, side, [side](double x, double y) {
    const double r = std::hypot(x - 0.5 * side, y - 0.5 * side) / side;
    const double depth = std::max(0.15 - std::abs(r - 0.3), 0.05 - r);
    return 0.5 + depth * side;
  });
}

/// Blots with soft edges, holes, specks and diagonal contacts.
inline AlphaMap random_map(std::mt19937& random, int width, int height) {
  std::uniform_real_distribution<double> unit;
  const double kx = 0.1 + unit(random), ky = 0.1 + unit(random), shift = 6 * unit(random);
  const double noise = unit(random) < 0.5 ? 0.1 : 1.5, bias = unit(random) - 0.3;
  return alpha_map(width, height, [&](double x, double y) {
    return std::sin(kx * x + shift) * std::cos(ky * y) + noise * (unit(random) - 0.5) + bias;
  });
}

/// The map in the middle of a transparent picture.
inline AlphaMap with_border(const AlphaMap& map, int border) {
  return alpha_map(map.width + 2 * border, map.height + 2 * border, [&](double x, double y) {
    const int u = static_cast<int>(x) - border, v = static_cast<int>(y) - border;
    const bool is_inside = u >= 0 && v >= 0 && u < map.width && v < map.height;
    return is_inside ? map.at(u, v) / 255.0 : 0.0;
  });
}

}  // namespace foldless::test
