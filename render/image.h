// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// 8-bit RGBA, rows from the top, straight (not premultiplied) alpha, sRGB.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 4 × width × height

  Image() = default;
  /// Transparent black.
  Image(int w, int h)
      : width(w),
        height(h),
        pixels(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  /// The four bytes of a pixel; y from the top.
  std::uint8_t* at(int x, int y) { return pixels.data() + offset(x, y); }
  const std::uint8_t* at(int x, int y) const { return pixels.data() + offset(x, y); }

  bool operator==(const Image&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};

/// The alpha of every pixel: width × height bytes.
std::vector<std::uint8_t> alpha_of(const Image& image);

/// Keyword → text of a picture: what is drawn and how it came about, e.g. Scene, Iteration, Energy.
using ImageTexts = std::map<std::string, std::string>;

/// How the names of files end that load_image() reads: ".png" and so on.
std::span<const std::string_view> image_extensions();
/// True for the names of such files, in any case.
bool is_image_file(const std::filesystem::path& file);

/// Reads a PNG, JPEG (CMYK too) or WebP, the first picture of a GIF, or the merged one of an
/// OpenRaster, Krita or Photoshop file; its first bytes tell which. Throws Error when the file
/// cannot be read, is none of these, is damaged, or is larger than 16384 pixels a side or 100
/// million in all.
Image load_image(const std::filesystem::path& path);

/// As load_image(), from the bytes of a PNG, JPEG, WebP or GIF. What it throws names no file.
Image decode_image(std::string_view bytes);

/// Throws Error on a size in pixels that load_image() refuses; for use before memory is taken.
void check_image_size(long width, long height);

/// PNG bytes of the image, its texts as Latin-1 or UTF-8 text chunks. Throws Error on an empty
/// image.
std::string encode_png(const Image& image, const ImageTexts& texts = {});

/// Writes encode_png() so that a whole file or none is there. Throws Error when it cannot.
void save_png(const std::filesystem::path& path, const Image& image, const ImageTexts& texts = {});

/// The text chunks of a PNG file. Throws Error as load_image().
ImageTexts read_png_texts(const std::filesystem::path& path);

}  // namespace foldless
