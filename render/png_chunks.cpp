// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/png_chunks.h"

#include <array>

namespace foldless {
namespace {

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

/// CRC-32 of ISO 3309, bits reflected: the remainders of every byte, followed by 0 to 7 zeros, so
/// that eight bytes are taken at a time.
constexpr CrcTables make_crc_tables() {
  CrcTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1U ? 0xEDB88320U : 0U);
    tables[0][byte] = crc;
  }
  for (std::size_t zeros = 1; zeros < tables.size(); ++zeros)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[zeros - 1][byte];
      tables[zeros][byte] = tables[0][before & 255U] ^ (before >> 8);
    }
  return tables;
}

constexpr CrcTables kTables = make_crc_tables();

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
  std::uint32_t crc = state_;
  const auto byte_of = [&](std::size_t i) {
    return std::uint32_t{static_cast<unsigned char>(bytes[i])};
  };
  for (; bytes.size() >= kTables.size(); bytes.remove_prefix(kTables.size())) {
    const std::uint32_t first =
        crc ^ (byte_of(0) | byte_of(1) << 8 | byte_of(2) << 16 | byte_of(3) << 24);
    crc = kTables[7][first & 255U] ^ kTables[6][(first >> 8) & 255U] ^
          kTables[5][(first >> 16) & 255U] ^ kTables[4][first >> 24] ^ kTables[3][byte_of(4)] ^
          kTables[2][byte_of(5)] ^ kTables[1][byte_of(6)] ^ kTables[0][byte_of(7)];
  }
  for (std::size_t i = 0; i < bytes.size(); ++i)
    crc = kTables[0][(crc ^ byte_of(i)) & 255U] ^ (crc >> 8);
  state_ = crc;
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
