// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/image.h"

namespace foldless {

using Rgb = std::array<std::uint8_t, 3>;

/// Opaque colours of pictures and how often they are there. Alpha below a half counts as nothing.
class ColourCount {
 public:
  void add(const Image& image);
  bool is_empty() const { return count_.empty(); }
  const std::unordered_map<std::uint32_t, std::size_t>& colours() const { return count_; }

 private:
  std::unordered_map<std::uint32_t, std::size_t> count_;  ///< by 0xRRGGBB
};

/// At most so many colours that stand for those of pictures: those themselves where they are few,
/// else the means of boxes in which the squared differences are least [Wu91 cuts along the axis of
/// largest variance].
class Palette {
 public:
  Palette(const ColourCount& count, std::size_t most);

  const std::vector<Rgb>& colours() const { return colours_; }
  /// The index of the nearest colour.
  std::uint8_t nearest(const Rgb& colour) const;
  /// The index for a pixel of a picture with few colours: ordered dither, the same at a place in
  /// every frame, so that what stands still does not flicker. A colour of the palette stays.
  std::uint8_t dithered(const Rgb& colour, int x, int y) const;

 private:
  std::vector<Rgb> colours_;
  double amplitude_ = 0;  ///< of the dither, grey levels
  mutable std::unordered_map<std::uint32_t, std::uint8_t> nearest_;
};

}  // namespace foldless
