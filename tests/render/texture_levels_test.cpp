// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_levels.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foldless {
namespace {

double mean(const Image& image, std::size_t channel) {
  double sum = 0;
  for (std::size_t p = channel; p < image.pixels.size(); p += 4) sum += image.pixels[p];
  return sum / (image.width * image.height);
}

TEST(TextureLevels, HalveTheSizeDownToOnePixel) {
  const TextureLevels levels = texture_levels(Image(13, 4));
  ASSERT_EQ(levels.size(), 4U);
  const int widths[] = {13, 6, 3, 1}, heights[] = {4, 2, 1, 1};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_EQ(levels[i].width, widths[i]);
    EXPECT_EQ(levels[i].height, heights[i]);
  }
  EXPECT_TRUE(texture_levels(Image()).empty());
}

TEST(TextureLevels, KeepTheMeanOfOddSizesToo) {
  Image ramp(37, 21);
  for (int y = 0; y < ramp.height; ++y)
    for (int x = 0; x < ramp.width; ++x) {
      const int value = 4 * x + 5 * y;
      for (int c = 0; c < 3; ++c) ramp.at(x, y)[c] = static_cast<std::uint8_t>(value);
      ramp.at(x, y)[3] = 255;
    }
  for (const Image& level : texture_levels(ramp))
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean(level, c), 4 * 18 + 5 * 10, 1.5);
}

TEST(TextureLevels, ArePremultiplied) {
  Image image(1, 1);
  image.pixels = {255, 100, 0, 51};
  EXPECT_EQ(texture_levels(image).at(0).pixels, (std::vector<std::uint8_t>{51, 20, 0, 51}));
}

}  // namespace
}  // namespace foldless
