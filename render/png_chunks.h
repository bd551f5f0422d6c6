// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace foldless {

/// The first eight bytes of every PNG file.
inline constexpr std::string_view kPngSignature{"\x89PNG\r\n\x1a\n", 8};

/// CRC-32 of ISO 3309, as in PNG and zlib, of bytes that come piece by piece.
class Crc32 {
 public:
  void add(std::string_view bytes);
  std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 0;
};

/// The same of bytes that are all there.
std::uint32_t crc32_of(std::string_view bytes);

/// A piece of a PNG file: what it is (four letters) and its bytes.
struct PngChunk {
  std::string_view type;
  std::string_view data;
};

/// A chunk as it stands in a file: length, type, data, CRC-32.
std::string png_chunk(const PngChunk& chunk);

/// Reads the chunk at `offset` and moves it to the next; nothing at the end of the file or where
/// the chunk is cut short. The first offset is the length of the signature.
std::optional<PngChunk> next_png_chunk(std::string_view file, std::size_t& offset);

/// A text chunk (iTXt, UTF-8, not compressed). The keyword has 1 to 79 Latin-1 letters.
std::string png_text_chunk(std::string_view keyword, std::string_view text);

}  // namespace foldless
