// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/photoshop_bytes.h"

#include <zlib.h>

#include "core/error.h"

namespace foldless {
namespace {

void append_utf8(std::uint32_t code, std::string& text) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto put_rest = [&](int shift) { put(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | (code >> 6));
  } else if (code < 0x10000) {
    put(0xE0 | (code >> 12));
    put_rest(6);
  } else {
    put(0xF0 | (code >> 18));
    put_rest(12);
    put_rest(6);
  }
  put_rest(0);
}

/// One row of PackBits: a count and that many bytes, or a negative count and the byte to repeat.
void unpack_row(std::string_view packed, std::size_t row_bytes, std::string& out) {
  const std::size_t end = out.size() + row_bytes;
  PhotoshopBytes bytes(packed);
  while (out.size() < end) {
    const int byte = static_cast<int>(bytes.byte());
    const int head = byte < 128 ? byte : byte - 256;
    if (head == -128) continue;
    const auto count = static_cast<std::size_t>(head < 0 ? 1 - head : 1 + head);
    if (out.size() + count > end) throw Error("the Photoshop file is damaged: a row is too long");
    if (head < 0)
      out.append(count, static_cast<char>(bytes.byte()));
    else
      out += bytes.take(count);
  }
}

std::string unzipped(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf length = size;
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
      length != size)
    throw Error("the Photoshop file is damaged: zipped pixels cannot be unpacked");
  return bytes;
}

/// Each byte is the difference to the one before it in its row.
void add_up_rows(std::string& planes, std::size_t row_bytes) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (i % row_bytes != 0) planes[i] = static_cast<char>(planes[i] + planes[i - 1]);
}

}  // namespace

std::string_view PhotoshopBytes::take(std::size_t count) {
  if (count > rest_.size()) throw Error("the Photoshop file is damaged or cut short");
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::uint32_t PhotoshopBytes::number(std::size_t bytes) {
  std::uint32_t value = 0;
  for (const char c : take(bytes)) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

std::string PhotoshopBytes::short_name() {
  const std::size_t length = byte();
  std::string name(take(length));
  take((4 - (length + 1) % 4) % 4);
  for (char& c : name)
    if (static_cast<unsigned char>(c) >= 0x80) c = '?';  // of an alphabet that is not said
  return name;
}

std::string PhotoshopBytes::long_name() {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  std::string name;
  for (std::uint32_t left = long_word(); left > 0; --left) {
    std::uint32_t code = word();
    if (code >= 0xD800 && code < 0xDC00 && left > 1) {
      const std::uint32_t low = word();
      --left;
      const bool is_pair = low >= 0xDC00 && low < 0xE000;
      code = is_pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : kReplacement;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = kReplacement;
    }
    if (code != 0) append_utf8(code, name);
  }
  return name;
}

std::string unpacked_rows(PhotoshopBytes& bytes, const PackedRows& rows) {
  constexpr unsigned kUnpacked = 0, kPackBits = 1, kZipped = 2, kZippedDifferences = 3;
  const unsigned packing = bytes.word();
  if (packing == kUnpacked) return std::string(bytes.take(rows.wanted * rows.row_bytes));
  if (packing == kZipped || packing == kZippedDifferences) {
    std::string planes = unzipped(bytes.take(bytes.left()), rows.wanted * rows.row_bytes);
    if (packing == kZippedDifferences) add_up_rows(planes, rows.row_bytes);
    return planes;
  }
  if (packing != kPackBits)
    throw Error("the Photoshop file packs its pixels in a way that is not known; save it again");
  PhotoshopBytes lengths(bytes.take(2 * rows.all));
  std::string planes;
  planes.reserve(rows.wanted * rows.row_bytes);
  for (std::size_t row = 0; row < rows.wanted; ++row)
    unpack_row(bytes.take(lengths.word()), rows.row_bytes, planes);
  return planes;
}

}  // namespace foldless
