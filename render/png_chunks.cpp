// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/png_chunks.h"

#include <zlib.h>

namespace foldless {
namespace {

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
          static_cast<char>(value >> 8), static_cast<char>(value)};
}

std::uint32_t from_big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes) value = (value << 8) | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

void Crc32::add(std::string_view bytes) {
  const auto* first = reinterpret_cast<const Bytef*>(bytes.data());
  value_ = static_cast<std::uint32_t>(crc32_z(value_, first, bytes.size()));
}

std::uint32_t crc32_of(std::string_view bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

std::string png_chunk(const PngChunk& chunk) {
  const std::string checked = std::string(chunk.type) + std::string(chunk.data);
  return big_endian(static_cast<std::uint32_t>(chunk.data.size())) + checked +
         big_endian(crc32_of(checked));
}

std::optional<PngChunk> next_png_chunk(std::string_view file, std::size_t& offset) {
  constexpr std::size_t kFrame = 12;  // length, type and CRC
  if (offset + kFrame > file.size()) return std::nullopt;
  const std::size_t length = from_big_endian(file.substr(offset, 4));
  if (length > file.size() - offset - kFrame) return std::nullopt;
  const PngChunk chunk{file.substr(offset + 4, 4), file.substr(offset + 8, length)};
  offset += length + kFrame;
  return chunk;
}

std::string png_text_chunk(std::string_view keyword, std::string_view text) {
  // Keyword, end of keyword, not compressed, method 0, no language, no translated keyword.
  std::string data(keyword);
  data.append(5, '\0');
  data += text;
  return png_chunk({"iTXt", data});
}

}  // namespace foldless
