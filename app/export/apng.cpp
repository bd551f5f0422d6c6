// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "app/export/film.h"
#include "render/png_chunks.h"

namespace foldless {
namespace {

void append_u32(std::string& bytes, std::size_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

void append_u16(std::string& bytes, int value) {
  bytes += static_cast<char>(value >> 8 & 0xFF);
  bytes += static_cast<char>(value & 0xFF);
}

/// A part of a picture: where it begins, and its pixels.
struct Part {
  int x = 0, y = 0;
  Image image;
};

bool is_same_row(const Image& a, const Image& b, int y) {
  return std::memcmp(a.at(0, y), b.at(0, y), 4 * static_cast<std::size_t>(a.width)) == 0;
}

bool is_same_column(const Image& a, const Image& b, int x) {
  for (int y = 0; y < a.height; ++y)
    if (std::memcmp(a.at(x, y), b.at(x, y), 4) != 0) return false;
  return true;
}

/// The smallest rectangle of `now` outside which it is as `before`; one pixel where all is.
Part what_differs(const Image& now, const Image& before) {
  int top = 0, bottom = now.height, left = 0, right = now.width;
  while (top < bottom - 1 && is_same_row(now, before, top)) ++top;
  while (bottom > top + 1 && is_same_row(now, before, bottom - 1)) --bottom;
  while (left < right - 1 && is_same_column(now, before, left)) ++left;
  while (right > left + 1 && is_same_column(now, before, right - 1)) --right;
  Part part{left, top, Image(right - left, bottom - top)};
  for (int y = top; y < bottom; ++y)
    std::memcpy(part.image.at(0, y - top), now.at(left, y),
                4 * static_cast<std::size_t>(part.image.width));
  return part;
}

/// Pictures are PNGs whose compressed pixels go into chunks of their own, one after the other.
class Apng : public Film {
 public:
  explicit Apng(FilmOptions options) : options_(std::move(options)) {}

  void add(const Image& image) override {
    const Part part = before_ ? what_differs(image, *before_) : Part{0, 0, image};
    const std::string png = encode_png(part.image, before_ ? ImageTexts() : options_.texts);
    if (!before_) file_ = kPngSignature;
    std::size_t offset = kPngSignature.size();
    bool is_control_due = true;
    while (const auto chunk = next_png_chunk(png, offset)) {
      if (chunk->type == "IEND") break;
      if (chunk->type == "IDAT") {
        if (std::exchange(is_control_due, false)) append_control(part);
        append_pixels(chunk->data);
      } else if (!before_) {
        file_ += png_chunk(*chunk);
        if (chunk->type == "IHDR") append_header();
      }
    }
    before_ = image;
  }

  std::string finish() override {
    file_ += png_chunk({"IEND", ""});
    return std::move(file_);
  }

 private:
  void append_header() {
    std::string data;
    append_u32(data, options_.count);
    append_u32(data, options_.loops ? 0 : 1);
    file_ += png_chunk({"acTL", data});
  }

  void append_control(const Part& part) {
    std::string data;
    append_u32(data, sequence_++);
    append_u32(data, static_cast<std::size_t>(part.image.width));
    append_u32(data, static_cast<std::size_t>(part.image.height));
    append_u32(data, static_cast<std::size_t>(part.x));
    append_u32(data, static_cast<std::size_t>(part.y));
    // Seconds as a fraction of 16 bits.
    const bool is_whole = options_.fps == std::round(options_.fps) && options_.fps < 65536;
    append_u16(
        data,
        is_whole ? 1 : static_cast<int>(std::clamp(std::round(1000 / options_.fps), 1.0, 65535.0)));
    append_u16(data, is_whole ? static_cast<int>(options_.fps) : 1000);
    data += '\0';  // What was drawn stays,
    data += '\0';  // and the part replaces it.
    file_ += png_chunk({"fcTL", data});
  }

  void append_pixels(std::string_view pixels) {
    if (!before_) {
      file_ += png_chunk({"IDAT", pixels});
      return;
    }
    std::string data;
    append_u32(data, sequence_++);
    data += pixels;
    file_ += png_chunk({"fdAT", data});
  }

  FilmOptions options_;
  std::string file_;
  std::size_t sequence_ = 0;
  std::optional<Image> before_;
};

}  // namespace

std::unique_ptr<Film> make_apng(const FilmOptions& options) {
  return std::make_unique<Apng>(options);
}

}  // namespace foldless
