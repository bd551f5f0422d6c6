// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image_difference.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace foldless {
namespace {

std::array<int, 4> premultiplied(const std::uint8_t* pixel) {
  const int alpha = pixel[3];
  const auto times_alpha = [alpha](int value) { return (value * alpha + 127) / 255; };
  return {times_alpha(pixel[0]), times_alpha(pixel[1]), times_alpha(pixel[2]), alpha};
}

std::array<int, 4> channels_apart(const std::uint8_t* a, const std::uint8_t* b) {
  const auto p = premultiplied(a), q = premultiplied(b);
  std::array<int, 4> apart{};
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = std::abs(p[i] - q[i]);
  return apart;
}

int largest_of(const std::array<int, 4>& channels) { return *std::ranges::max_element(channels); }

}  // namespace

ImageDifference difference_of(const Image& a, const Image& b, int tolerance) {
  ImageDifference difference;
  difference.left = a.width;
  difference.top = a.height;
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto apart = channels_apart(a.at(x, y), b.at(x, y));
      for (const int channel : apart) sum += channel;
      const int largest = largest_of(apart);
      difference.largest = std::max(difference.largest, largest);
      if (largest <= tolerance) continue;
      ++difference.pixels;
      difference.left = std::min(difference.left, x);
      difference.right = std::max(difference.right, x);
      difference.top = std::min(difference.top, y);
      difference.bottom = std::max(difference.bottom, y);
    }
  difference.mean = a.pixels.empty() ? 0 : sum / static_cast<double>(a.pixels.size());
  return difference;
}

Image picture_of_difference(const Image& a, const Image& b, int tolerance) {
  Image picture(a.width, a.height);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto p = premultiplied(a.at(x, y));
      const int paper = 255 - p[3];
      const int grey = 192 + ((p[0] + p[1] + p[2]) / 3 + paper) / 4;
      const int apart = largest_of(channels_apart(a.at(x, y), b.at(x, y)));
      const int pale = apart > tolerance ? 128 - apart / 2 : grey;
      std::uint8_t* pixel = picture.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(apart > tolerance ? 224 : std::min(grey, 255));
      pixel[1] = pixel[2] = static_cast<std::uint8_t>(std::min(pale, 255));
      pixel[3] = 255;
    }
  return picture;
}

}  // namespace foldless
