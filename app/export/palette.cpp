// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

struct Counted {
  Rgb colour;
  double weight;
};

std::uint32_t packed(const Rgb& c) {
  return static_cast<std::uint32_t>(c[0]) << 16 | static_cast<std::uint32_t>(c[1]) << 8 | c[2];
}

Rgb unpacked(std::uint32_t c) {
  return {static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8 & 0xFF),
          static_cast<std::uint8_t>(c & 0xFF)};
}

int squared_distance(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int d = static_cast<int>(a[k]) - static_cast<int>(b[k]);
    sum += d * d;
  }
  return sum;
}

/// Colours [begin, end) of the list, and how much they differ from their mean.
struct ColourBox {
  std::size_t begin, end;
  std::array<double, 3> mean{};
  std::size_t axis = 0;  ///< along which they differ most
  double error = 0;      ///< sum of squared differences along it
};

ColourBox box_of(const std::vector<Counted>& colours, std::size_t begin, std::size_t end) {
  ColourBox box{begin, end, {}, 0, 0};
  double weight = 0;
  std::array<double, 3> square{};
  for (std::size_t i = begin; i < end; ++i) {
    weight += colours[i].weight;
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = colours[i].colour[k];
      box.mean[k] += colours[i].weight * value;
      square[k] += colours[i].weight * value * value;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    box.mean[k] /= weight;
    const double error = square[k] - weight * box.mean[k] * box.mean[k];
    if (error > box.error) {
      box.error = error;
      box.axis = k;
    }
  }
  return box;
}

std::vector<Rgb> cut(std::vector<Counted> colours, std::size_t most) {
  std::vector<ColourBox> boxes{box_of(colours, 0, colours.size())};
  while (boxes.size() < most) {
    const auto worst = std::ranges::max_element(boxes, {}, &ColourBox::error);
    if (worst->end - worst->begin < 2 || worst->error <= 0) break;
    const ColourBox box = *worst;
    const auto first = colours.begin() + static_cast<std::ptrdiff_t>(box.begin);
    const auto last = colours.begin() + static_cast<std::ptrdiff_t>(box.end);
    const auto middle = std::partition(
        first, last, [&](const Counted& c) { return c.colour[box.axis] <= box.mean[box.axis]; });
    const auto split = static_cast<std::size_t>(middle - colours.begin());
    if (split == box.begin || split == box.end) break;
    *worst = box_of(colours, box.begin, split);
    boxes.push_back(box_of(colours, split, box.end));
  }
  std::vector<Rgb> means;
  for (const ColourBox& box : boxes) {
    Rgb& mean = means.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      mean[k] = static_cast<std::uint8_t>(std::lround(box.mean[k]));
  }
  return means;
}

/// The mean distance of a colour to the one nearest to it.
double spacing(const std::vector<Rgb>& colours) {
  double sum = 0;
  for (const Rgb& a : colours) {
    int nearest = std::numeric_limits<int>::max();
    for (const Rgb& b : colours)
      if (&a != &b) nearest = std::min(nearest, squared_distance(a, b));
    sum += std::sqrt(nearest);
  }
  return sum / static_cast<double>(colours.size());
}

/// Thresholds of an ordered dither of 8 × 8 pixels, within ±½.
double threshold(int x, int y) {
  int value = 0;
  for (int bit = 0; bit < 3; ++bit) {
    const int a = x >> bit & 1, b = y >> bit & 1;
    value = value << 2 | (a ^ b) << 1 | b;
  }
  return (value + 0.5) / 64 - 0.5;
}

}  // namespace

void ColourCount::add(const Image& image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4)
    if (image.pixels[p + 3] >= 128)
      ++count_[packed({image.pixels[p], image.pixels[p + 1], image.pixels[p + 2]})];
}

Palette::Palette(const ColourCount& count, std::size_t most) {
  std::vector<Counted> colours;
  for (const auto& [colour, times] : count.colours())
    colours.push_back({unpacked(colour), static_cast<double>(times)});
  if (colours.empty()) colours.push_back({{0, 0, 0}, 1});
  // In one order whatever the table's is: the same pictures have the same palette.
  std::ranges::sort(colours, {}, &Counted::colour);
  if (colours.size() <= most) {
    for (const Counted& colour : colours) colours_.push_back(colour.colour);
  } else {
    colours_ = cut(std::move(colours), most);
    amplitude_ = spacing(colours_);
  }
  for (std::size_t i = 0; i < colours_.size(); ++i)
    nearest_.emplace(packed(colours_[i]), static_cast<std::uint8_t>(i));
}

std::uint8_t Palette::nearest(const Rgb& colour) const {
  const auto [place, is_new] = nearest_.try_emplace(packed(colour));
  if (!is_new) return place->second;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colours_.size(); ++i)
    if (const int distance = squared_distance(colours_[i], colour); distance < least) {
      least = distance;
      place->second = static_cast<std::uint8_t>(i);
    }
  return place->second;
}

std::uint8_t Palette::dithered(const Rgb& colour, int x, int y) const {
  const std::uint8_t plain = nearest(colour);
  if (amplitude_ == 0 || colours_[plain] == colour) return plain;
  Rgb shifted = colour;
  const double by = amplitude_ * threshold(x, y);
  for (std::uint8_t& channel : shifted)
    channel = static_cast<std::uint8_t>(std::clamp(std::lround(channel + by), 0L, 255L));
  return nearest(shifted);
}

}  // namespace foldless
