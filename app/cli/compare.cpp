// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <iostream>
#include <string>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "core/error.h"
#include "render/image_difference.h"

namespace foldless {
namespace {

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " × " + std::to_string(image.height);
}

std::string words_on(const ImageDifference& difference, const Image& image) {
  const double all = static_cast<double>(image.width) * image.height;
  std::array<char, 200> words{};
  std::snprintf(words.data(), words.size(),
                "different: %lld pixels (%.3g %%) between (%d, %d) and (%d, %d), by up to %d grey "
                "levels, %.3g in the mean of all",
                difference.pixels, 100 * static_cast<double>(difference.pixels) / all,
                difference.left, difference.top, difference.right, difference.bottom,
                difference.largest, difference.mean);
  return words.data();
}

}  // namespace

int compare(const CompareCall& call) {
  if (call.tolerance < 0 || call.tolerance > 255)
    throw Error("--tolerance takes grey levels from 0 to 255");
  if (call.diff && call.diff->extension() != ".png")
    throw Error(call.diff->string() + ": pictures are written as PNG; end the name with .png");
  const Image a = load_image(call.first), b = load_image(call.second);
  if (a.width != b.width || a.height != b.height) {
    std::cout << "different: " << call.first.string() << " has " << size_of(a) << " pixels, "
              << call.second.string() << " has " << size_of(b) << '\n';
    return kExitNotSatisfied;
  }
  if (call.diff) save_png(*call.diff, picture_of_difference(a, b, call.tolerance));
  const ImageDifference difference = difference_of(a, b, call.tolerance);
  if (difference.pixels > 0) {
    std::cout << words_on(difference, a) << '\n';
    return kExitNotSatisfied;
  }
  if (difference.largest == 0)
    std::cout << "alike, pixel for pixel\n";
  else
    std::cout << "alike within " << difference.largest << " grey levels\n";
  return kExitDone;
}

}  // namespace foldless
