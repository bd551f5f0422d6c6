// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/krita_tiles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <utility>

#include "core/error.h"
#include "render/layered/lzf.h"

namespace foldless {
namespace {

constexpr int kTileSide = 64;
constexpr std::size_t kTilePixels = std::size_t{kTileSide} * kTileSide;
constexpr std::size_t kTileBytes = 4 * kTilePixels;
constexpr std::size_t kLongestLine = 80;
constexpr int kFarthestTile = 1'000'000'000;

using TilePixels = std::array<char, kTileBytes>;

Error damaged_tiles() { return Error("its tiles are damaged"); }

/// Takes a line off the front.
std::string_view next_line(std::string_view& rest) {
  const std::size_t end = rest.substr(0, kLongestLine).find('\n');
  if (end == std::string_view::npos) throw damaged_tiles();
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return line;
}

/// Takes what ends with a separator, or is all there is, off the front.
std::string_view next_field(std::string_view& line, char separator) {
  const std::size_t end = std::min(line.find(separator), line.size());
  const std::string_view field = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return field;
}

int tile_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) throw damaged_tiles();
  return number;
}

/// Reads the head; returns how many tiles there are.
int read_head(std::string_view& rest) {
  constexpr std::array<std::pair<std::string_view, int>, 4> kExpected{
      {{"VERSION", 2}, {"TILEWIDTH", kTileSide}, {"TILEHEIGHT", kTileSide}, {"PIXELSIZE", 4}}};
  for (const auto& [key, value] : kExpected) {
    std::string_view line = next_line(rest);
    if (next_field(line, ' ') != key || tile_number(line) != value)
      throw Error("its tiles are of an unknown kind; only 64 x 64 pixels of 8-bit RGBA are read");
  }
  std::string_view line = next_line(rest);
  if (next_field(line, ' ') != "DATA") throw damaged_tiles();
  return tile_number(line);
}

/// Unpacks a tile; its colours stand one after the other or, where that did not make it shorter,
/// pixel by pixel as they are.
void unpack(std::string_view data, TilePixels& pixels) {
  constexpr char kRaw = 0, kCompressed = 1;
  if (data.empty()) throw damaged_tiles();
  const char flag = data.front();
  data.remove_prefix(1);
  if (flag == kRaw && data.size() == kTileBytes) {
    std::ranges::copy(data, pixels.begin());
    return;
  }
  TilePixels planes;
  if (flag != kCompressed || lzf_decompress(data.data(), static_cast<unsigned>(data.size()),
                                            planes.data(), kTileBytes) != kTileBytes)
    throw damaged_tiles();
  for (std::size_t p = 0; p < kTilePixels; ++p)
    for (std::size_t c = 0; c < 4; ++c) pixels[4 * p + c] = planes[c * kTilePixels + p];
}

void put(const char* blue_green_red_alpha, std::uint8_t* pixel) {
  constexpr std::array<std::size_t, 4> kPlaces{2, 1, 0, 3};
  for (std::size_t c = 0; c < 4; ++c)
    pixel[c] = static_cast<std::uint8_t>(blue_green_red_alpha[kPlaces[c]]);
}

/// Copies what of a tile lies on the canvas.
void put_tile(const TilePixels& pixels, int left, int top, Image& canvas) {
  for (int y = std::max(0, -top); y < std::min(kTileSide, canvas.height - top); ++y)
    for (int x = std::max(0, -left); x < std::min(kTileSide, canvas.width - left); ++x)
      put(&pixels[4 * static_cast<std::size_t>(y * kTileSide + x)], canvas.at(left + x, top + y));
}

}  // namespace

PictureLayer with_tiles(std::string_view file, std::string_view default_pixel, PictureLayer layer,
                        const CanvasSize& canvas) {
  if (default_pixel.size() != 4) throw Error("its default pixel is damaged");
  layer.image = Image(canvas.width, canvas.height);
  for (std::size_t p = 0; p < layer.image.pixels.size(); p += 4)
    put(default_pixel.data(), &layer.image.pixels[p]);
  TilePixels pixels;
  for (int left = read_head(file); left > 0; --left) {
    std::string_view line = next_line(file);
    const int x = tile_number(next_field(line, ',')), y = tile_number(next_field(line, ','));
    const std::string_view packing = next_field(line, ',');
    const auto size = static_cast<std::size_t>(std::max(0, tile_number(line)));
    if (packing != "LZF" || size > file.size() || std::abs(static_cast<long>(x)) > kFarthestTile ||
        std::abs(static_cast<long>(y)) > kFarthestTile)
      throw damaged_tiles();
    unpack(file.substr(0, size), pixels);
    file.remove_prefix(size);
    put_tile(pixels, layer.x + x, layer.y + y, layer.image);
  }
  layer.x = layer.y = 0;
  return layer;
}

}  // namespace foldless
