// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

struct zip;

namespace foldless {

/// True for bytes that begin as a zip archive does.
bool is_zip(std::string_view bytes);

/// A zip archive in memory, for reading.
class ZipArchive {
 public:
  /// Keeps a reference to the bytes. Throws Error when they are damaged.
  explicit ZipArchive(std::string_view bytes);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  bool has(const std::string& name) const;
  /// A file of the archive, unpacked. Throws Error when it is missing, damaged, locked, or larger
  /// than `most` bytes.
  std::string read(const std::string& name, std::uint64_t most) const;

 private:
  zip* archive_ = nullptr;
};

/// For a file that describes others.
inline constexpr std::uint64_t kMostXmlBytes = 16 << 20;
/// For one that holds pixels: those of the largest picture, uncompressed.
inline constexpr std::uint64_t kMostPixelBytes = 512 << 20;

}  // namespace foldless
