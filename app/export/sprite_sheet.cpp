// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/sprite_sheet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "render/packed_bytes.h"
#include "render/png_rows.h"

namespace foldless {
namespace {

constexpr double kMostInAll = 1e8;

bool is_seen(const Image& image, int x, int y) { return image.at(x, y)[3] > 0; }

}  // namespace

void SpriteSheet::add(const Image& image) {
  width_ = image.width;
  height_ = image.height;
  int left = image.width, top = image.height, right = 0, bottom = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (!is_seen(image, x, y)) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = std::max(bottom, y + 1);
    }
  // A picture of nothing is one transparent pixel.
  if (right == 0) left = top = 0, right = bottom = 1;
  Sprite& sprite = sprites_.emplace_back();
  sprite.x = left;
  sprite.y = top;
  sprite.width = right - left;
  sprite.height = bottom - top;
  std::vector<std::uint8_t> pixels;
  for (int y = top; y < bottom; ++y)
    pixels.insert(pixels.end(), image.at(left, y),
                  image.at(left, y) + 4 * static_cast<std::ptrdiff_t>(sprite.width));
  sprite.pixels = packed(pixels);
  area_ += static_cast<double>(sprite.width) * sprite.height;
  if (area_ > kMostInAll)
    throw Error("the sprite sheet would have more than 100 million pixels: take fewer frames or " +
                std::string("a smaller size"));
}

SpriteSheet::Grid SpriteSheet::grid() const {
  Grid grid;
  for (const Sprite& sprite : sprites_) {
    grid.width = std::max(grid.width, sprite.width + 1);
    grid.height = std::max(grid.height, sprite.height + 1);
  }
  const auto count = static_cast<double>(sprites_.size());
  grid.columns =
      std::clamp(static_cast<int>(std::lround(std::sqrt(count * grid.height / grid.width))), 1,
                 static_cast<int>(sprites_.size()));
  grid.rows = (static_cast<int>(sprites_.size()) + grid.columns - 1) / grid.columns;
  return grid;
}

std::array<int, 2> SpriteSheet::size(bool power_of_two) const {
  const Grid cells = grid();
  const auto side = [&](int length) {
    return power_of_two ? static_cast<int>(std::bit_ceil(static_cast<unsigned>(length))) : length;
  };
  return {side(cells.columns * cells.width), side(cells.rows * cells.height)};
}

Image SpriteSheet::strip(int row, int width) const {
  const Grid cells = grid();
  Image strip(width, cells.height);
  for (int column = 0; column < cells.columns; ++column) {
    const int number = row * cells.columns + column;
    if (number >= static_cast<int>(sprites_.size())) break;
    const Sprite& sprite = sprites_[static_cast<std::size_t>(number)];
    const std::size_t line = 4 * static_cast<std::size_t>(sprite.width);
    const auto pixels = unpacked(sprite.pixels, line * static_cast<std::size_t>(sprite.height));
    for (int y = 0; y < sprite.height; ++y)
      std::memcpy(strip.at(column * cells.width, y),
                  pixels.data() + line * static_cast<std::size_t>(y), line);
  }
  return strip;
}

std::string SpriteSheet::png(bool power_of_two, const ImageTexts& texts) const {
  const auto [width, height] = size(power_of_two);
  check_image_size(width, height);
  const Grid cells = grid();
  PngRows rows(width, height, texts);
  const std::size_t line = 4 * static_cast<std::size_t>(width);
  for (int row = 0; row < cells.rows; ++row) {
    const Image cells_of_row = strip(row, width);
    for (int y = 0; y < cells.height; ++y)
      rows.add({cells_of_row.at(0, y), cells_of_row.at(0, y) + line});
  }
  for (int y = cells.rows * cells.height; y < height; ++y)
    rows.add(std::vector<std::uint8_t>(line));
  return rows.finish();
}

std::string SpriteSheet::json(bool power_of_two, const std::string& picture) const {
  using nlohmann::ordered_json;
  const auto rectangle = [](int x, int y, const Sprite& of) {
    return ordered_json{{"x", x}, {"y", y}, {"w", of.width}, {"h", of.height}};
  };
  const auto [width, height] = size(power_of_two);
  const Grid cells = grid();
  ordered_json frames = ordered_json::array();
  for (std::size_t i = 0; i < sprites_.size(); ++i) {
    const Sprite& sprite = sprites_[i];
    const int column = static_cast<int>(i) % cells.columns;
    const int row = static_cast<int>(i) / cells.columns;
    std::string name = std::to_string(i);
    name.insert(0, 6 - std::min<std::size_t>(6, name.size()), '0');
    const auto end_of = [&](std::size_t n) {
      return std::lround(1000 * static_cast<double>(n) / fps_);
    };
    frames.push_back({{"filename", name},
                      {"frame", rectangle(column * cells.width, row * cells.height, sprite)},
                      {"rotated", false},
                      {"trimmed", sprite.width < width_ || sprite.height < height_},
                      {"spriteSourceSize", rectangle(sprite.x, sprite.y, sprite)},
                      {"sourceSize", {{"w", width_}, {"h", height_}}},
                      {"pivot", {{"x", 0.5}, {"y", 0.5}}},
                      {"duration", end_of(i + 1) - end_of(i)}});
  }
  const ordered_json text{{"frames", std::move(frames)},
                          {"meta",
                           {{"app", "Foldless"},
                            {"image", picture},
                            {"format", "RGBA8888"},
                            {"size", {{"w", width}, {"h", height}}},
                            {"scale", 1}}}};
  return text.dump(1) + '\n';
}

}  // namespace foldless
