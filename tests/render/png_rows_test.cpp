// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/png_rows.h"

#include <gtest/gtest.h>

#include <random>

#include "render/packed_bytes.h"

namespace foldless {
namespace {

/// Smooth on the left, noise on the right.
Image half_noise(int width, int height) {
  std::mt19937 random(3);
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int k = 0; k < 4; ++k)
        image.at(x, y)[k] =
            static_cast<std::uint8_t>(x < width / 2 ? 2 * x + 3 * y + 60 * k : random());
  return image;
}

std::string file_of(const Image& image, const ImageTexts& texts) {
  PngRows rows(image.width, image.height, texts);
  const std::ptrdiff_t line = 4 * static_cast<std::ptrdiff_t>(image.width);
  for (int y = 0; y < image.height; ++y) rows.add({image.at(0, y), image.at(0, y) + line});
  return rows.finish();
}

TEST(PngRows, AreReadBackAsTheyWere) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {1, 9}, {301, 203}}) {
    const Image image = half_noise(width, height);
    EXPECT_EQ(decode_image(file_of(image, {})), image) << width << " x " << height;
  }
}

TEST(PngRows, TakeHardlyMoreThanAPictureThatIsEncodedAsAWhole) {
  const Image image = half_noise(301, 203);
  const ImageTexts texts{{"Scene", "walk.json"}};
  const std::string file = file_of(image, texts);
  EXPECT_LT(static_cast<double>(file.size()),
            1.02 * static_cast<double>(encode_png(image, texts).size()));
  EXPECT_NE(file.find("walk.json"), file.npos);
}

TEST(PackedBytes, AreUnpackedToTheSame) {
  const std::vector<std::uint8_t> pixels = half_noise(50, 40).pixels;
  EXPECT_LT(packed(pixels).size(), pixels.size());
  EXPECT_EQ(unpacked(packed(pixels), pixels.size()), pixels);
  EXPECT_TRUE(unpacked(packed({}), 0).empty());
  EXPECT_ANY_THROW(unpacked("nonsense", 10));
}

}  // namespace
}  // namespace foldless
