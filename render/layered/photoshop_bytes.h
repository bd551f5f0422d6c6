// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foldless {

/// Takes numbers, high byte first, and runs of bytes off the front of a Photoshop file or of a part
/// of one. Every function throws Error where the part ends before.
class PhotoshopBytes {
 public:
  /// Keeps a reference.
  explicit PhotoshopBytes(std::string_view bytes) : rest_(bytes) {}

  bool is_at_end() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }
  std::string_view take(std::size_t count);
  unsigned byte() { return number(1); }
  unsigned word() { return number(2); }
  std::uint32_t long_word() { return number(4); }
  int signed_word() { return static_cast<std::int16_t>(number(2)); }
  int signed_long_word() { return static_cast<std::int32_t>(number(4)); }
  /// What follows its own length, of four bytes.
  PhotoshopBytes part() { return PhotoshopBytes(take(long_word())); }
  /// A name after its length, of one byte, with as many bytes more as make a multiple of four.
  std::string short_name();
  /// A name in UTF-16 after the number of its units, of four bytes; as UTF-8.
  std::string long_name();

 private:
  std::uint32_t number(std::size_t bytes);

  std::string_view rest_;
};

/// How rows of bytes are packed in a file, and how many there are.
struct PackedRows {
  std::size_t row_bytes;
  std::size_t wanted;  ///< the first of them, which are unpacked
  std::size_t all;
};

/// Takes the packing, then the lengths of all rows where it is PackBits, and unpacks rows; one
/// plane after the other. What is zipped is taken to its end; its rows hold single bytes.
std::string unpacked_rows(PhotoshopBytes& bytes, const PackedRows& rows);

}  // namespace foldless
