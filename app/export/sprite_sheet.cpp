// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/sprite_sheet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"

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
  sprite.image = Image(right - left, bottom - top);
  for (int y = top; y < bottom; ++y)
    std::memcpy(sprite.image.at(0, y - top), image.at(left, y),
                4 * static_cast<std::size_t>(sprite.image.width));
  area_ += static_cast<double>(sprite.image.width) * sprite.image.height;
  if (area_ > kMostInAll)
    throw Error("the sprite sheet would have more than 100 million pixels: take fewer frames or " +
                std::string("a smaller size"));
}

SpriteSheet::Grid SpriteSheet::grid() const {
  Grid grid;
  for (const Sprite& sprite : sprites_) {
    grid.width = std::max(grid.width, sprite.image.width + 1);
    grid.height = std::max(grid.height, sprite.image.height + 1);
  }
  const auto count = static_cast<double>(sprites_.size());
  grid.columns =
      std::clamp(static_cast<int>(std::lround(std::sqrt(count * grid.height / grid.width))), 1,
                 static_cast<int>(sprites_.size()));
  grid.rows = (static_cast<int>(sprites_.size()) + grid.columns - 1) / grid.columns;
  return grid;
}

Image SpriteSheet::sheet(bool power_of_two) const {
  const Grid cells = grid();
  const auto side = [&](int length) {
    return power_of_two ? static_cast<int>(std::bit_ceil(static_cast<unsigned>(length))) : length;
  };
  const int width = side(cells.columns * cells.width), height = side(cells.rows * cells.height);
  check_image_size(width, height);
  Image sheet(width, height);
  for (std::size_t i = 0; i < sprites_.size(); ++i) {
    const int column = static_cast<int>(i) % cells.columns;
    const int row = static_cast<int>(i) / cells.columns;
    const Image& image = sprites_[i].image;
    for (int y = 0; y < image.height; ++y)
      std::memcpy(sheet.at(column * cells.width, row * cells.height + y), image.at(0, y),
                  4 * static_cast<std::size_t>(image.width));
  }
  return sheet;
}

std::string SpriteSheet::json(const Image& sheet, const std::string& picture) const {
  using nlohmann::ordered_json;
  const auto rectangle = [](int x, int y, const Image& image) {
    return ordered_json{{"x", x}, {"y", y}, {"w", image.width}, {"h", image.height}};
  };
  const Grid cells = grid();
  ordered_json frames = ordered_json::array();
  for (std::size_t i = 0; i < sprites_.size(); ++i) {
    const auto& [x, y, image] = sprites_[i];
    const int column = static_cast<int>(i) % cells.columns;
    const int row = static_cast<int>(i) / cells.columns;
    std::string name = std::to_string(i);
    name.insert(0, 6 - std::min<std::size_t>(6, name.size()), '0');
    const auto end_of = [&](std::size_t n) {
      return std::lround(1000 * static_cast<double>(n) / fps_);
    };
    frames.push_back({{"filename", name},
                      {"frame", rectangle(column * cells.width, row * cells.height, image)},
                      {"rotated", false},
                      {"trimmed", image.width < width_ || image.height < height_},
                      {"spriteSourceSize", rectangle(x, y, image)},
                      {"sourceSize", {{"w", width_}, {"h", height_}}},
                      {"pivot", {{"x", 0.5}, {"y", 0.5}}},
                      {"duration", end_of(i + 1) - end_of(i)}});
  }
  const ordered_json text{{"frames", std::move(frames)},
                          {"meta",
                           {{"app", "Foldless"},
                            {"image", picture},
                            {"format", "RGBA8888"},
                            {"size", {{"w", sheet.width}, {"h", sheet.height}}},
                            {"scale", 1}}}};
  return text.dump(1) + '\n';
}

}  // namespace foldless
