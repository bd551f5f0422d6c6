// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image_difference.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foldless {
namespace {

Image grey(int width, int height, std::uint8_t level) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = i % 4 == 3 ? 255 : level;
  return image;
}

TEST(ImageDifference, OfAPictureWithItselfIsNothing) {
  const Image image = grey(7, 5, 100);
  const ImageDifference difference = difference_of(image, image, 0);
  EXPECT_EQ(difference.pixels, 0);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(difference.mean, 0);
}

TEST(ImageDifference, SaysHowMuchAndWhere) {
  const Image a = grey(10, 8, 100);
  Image b = a;
  b.at(2, 3)[0] = 130;
  b.at(6, 5)[2] = 90;
  const ImageDifference difference = difference_of(a, b, 9);
  EXPECT_EQ(difference.pixels, 2);
  EXPECT_EQ(difference.largest, 30);
  EXPECT_DOUBLE_EQ(difference.mean, 40.0 / (4 * 80));
  EXPECT_EQ(difference.left, 2);
  EXPECT_EQ(difference.top, 3);
  EXPECT_EQ(difference.right, 6);
  EXPECT_EQ(difference.bottom, 5);
  EXPECT_EQ(difference_of(a, b, 10).pixels, 1) << "ten levels are within the tolerance";
  EXPECT_EQ(difference_of(a, b, 30).pixels, 0);
}

TEST(ImageDifference, DoesNotSeeTheColourOfWhatIsTransparent) {
  Image a(3, 3), b(3, 3);
  b.at(1, 1)[0] = 255;
  EXPECT_EQ(difference_of(a, b, 0).pixels, 0);
  b.at(1, 1)[3] = 255;
  EXPECT_EQ(difference_of(a, b, 0).pixels, 1);
}

TEST(PictureOfDifference, IsRedWhereTheyDifferAndPaleElsewhere) {
  const Image a = grey(4, 4, 0);
  Image b = a;
  b.at(3, 0)[1] = 255;
  const Image picture = picture_of_difference(a, b, 0);
  EXPECT_GT(picture.at(3, 0)[0], picture.at(3, 0)[1] + 100);
  EXPECT_EQ(picture.at(0, 0)[0], picture.at(0, 0)[1]);
  EXPECT_GE(picture.at(0, 0)[0], 190);
}

}  // namespace
}  // namespace foldless
