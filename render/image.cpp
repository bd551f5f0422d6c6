// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/late_images.h"
#include "render/png_chunks.h"

namespace foldless {
namespace {

constexpr std::size_t kHeaderEnd = kPngSignature.size() + 25;  // after the IHDR chunk

std::string encode_pixels(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw Error(std::string("the picture cannot be written as PNG: ") + png.message);
  bytes.resize(size);
  return bytes;
}

/// Keyword and text of a tEXt or iTXt chunk that is not compressed; an empty keyword for others.
std::pair<std::string, std::string> text_of(const PngChunk& chunk) {
  const std::size_t end = chunk.data.find('\0');
  if (end == std::string_view::npos) return {};
  const std::string keyword(chunk.data.substr(0, end));
  if (chunk.type == "tEXt") return {keyword, std::string(chunk.data.substr(end + 1))};
  if (chunk.type != "iTXt" || end + 2 >= chunk.data.size() || chunk.data[end + 1] != 0) return {};
  const std::size_t language_end = chunk.data.find('\0', end + 3);
  if (language_end == std::string_view::npos) return {};
  const std::size_t translation_end = chunk.data.find('\0', language_end + 1);
  if (translation_end == std::string_view::npos) return {};
  return {keyword, std::string(chunk.data.substr(translation_end + 1))};
}

}  // namespace

std::span<const std::string_view> image_extensions() {
  static constexpr std::array<std::string_view, 8> kExtensions{".png", ".jpg", ".jpeg", ".webp",
                                                               ".gif", ".ora", ".kra",  ".psd"};
  return kExtensions;
}

bool is_image_file(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::find(image_extensions(), extension) != image_extensions().end();
}

std::vector<std::uint8_t> alpha_of(const Image& image) {
  std::vector<std::uint8_t> alpha(image.pixels.size() / 4);
  for (std::size_t p = 0; p < alpha.size(); ++p) alpha[p] = image.pixels[4 * p + 3];
  return alpha;
}

std::string encode_png(const Image& image, const ImageTexts& texts) {
  if (image.width < 1 || image.height < 1) throw Error("an empty picture cannot be written");
  std::string bytes = encode_pixels(image);
  std::string chunks;
  for (const auto& [keyword, text] : texts) chunks += png_text_chunk(keyword, text);
  bytes.insert(kHeaderEnd, chunks);
  return bytes;
}

void save_png(const std::filesystem::path& path, const Image& image, const ImageTexts& texts) {
  write_file_atomically(path, encode_png(image, texts));
}

ImageTexts read_png_texts(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  if (!file.starts_with(kPngSignature)) throw Error(path.string() + ": is not a PNG picture");
  ImageTexts texts;
  std::size_t offset = kPngSignature.size();
  while (const auto chunk = next_png_chunk(file, offset)) {
    auto [keyword, text] = text_of(*chunk);
    if (!keyword.empty()) texts[keyword] = std::move(text);
  }
  return texts;
}

}  // namespace foldless
