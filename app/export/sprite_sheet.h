// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/image.h"

namespace foldless {

/// Pictures of one size on a grid, each cut down to what is not transparent.
class SpriteSheet {
 public:
  /// `fps`: pictures a second.
  explicit SpriteSheet(double fps) : fps_(fps) {}

  /// Throws Error when the sheet would be larger than pictures may be.
  void add(const Image& image);
  /// The PNG file of all of them, about as wide as high, a pixel apart; with `power_of_two` both
  /// sides are padded to powers of two. Throws Error when it is larger than pictures may be.
  std::string png(bool power_of_two, const ImageTexts& texts) const;
  /// Where the pictures are: an array of frames as TexturePacker and Aseprite write them, with
  /// `frame` (on the sheet), `spriteSourceSize` (where it was cut from), `sourceSize`, `pivot`
  /// (the middle, of the source) and `duration` [ms]; `meta` names the picture and its size.
  std::string json(bool power_of_two, const std::string& picture) const;

 private:
  struct Sprite {
    int x = 0, y = 0;  ///< of the upper left corner in the source
    int width = 0, height = 0;
    std::string pixels;  ///< see packed(): all of them are kept until the end
  };
  struct Grid {
    int columns = 1, rows = 1, width = 1, height = 1;  ///< of a cell, with its gap
  };
  Grid grid() const;
  std::array<int, 2> size(bool power_of_two) const;
  /// The cells of a row of the grid, as wide as the sheet.
  Image strip(int row, int width) const;

  double fps_;
  int width_ = 0, height_ = 0;  ///< of the sources
  std::vector<Sprite> sprites_;
  double area_ = 0;  ///< pixels
};

}  // namespace foldless
