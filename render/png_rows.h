// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/image.h"

namespace foldless {

/// A PNG file of RGBA pixels that are given row by row, so that the picture need not be in memory
/// as a whole.
class PngRows {
 public:
  PngRows(int width, int height, const ImageTexts& texts);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  /// The next row, 4 × width bytes, from the top.
  void add(const std::vector<std::uint8_t>& row);
  /// The file. Precondition: as many rows were added as it is high.
  std::string finish();

 private:
  struct Deflater;
  void deflate_line(const std::vector<std::uint8_t>& line, bool is_last);

  std::string file_;
  std::vector<std::uint8_t> above_;  ///< the row before; zeros before the first
  std::unique_ptr<Deflater> deflater_;
};

}  // namespace foldless
