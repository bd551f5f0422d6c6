// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/jpeg_scans.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace foldless {
namespace {

/// Programs write about ten, of four inks some twenty.
constexpr std::size_t kMostScans = 100;
/// Pixels that all scans together go over: some seconds.
constexpr std::size_t kMostScannedPixels = 3'000'000'000;

constexpr unsigned char kFill = 0xFF, kStartOfScan = 0xDA, kFirstWithLength = 0xC0;

/// Markers that no length follows: restarts, start and end of the picture. So are those that
/// decoders take for damage.
bool stands_alone(unsigned char marker) {
  return marker < kFirstWithLength || (marker >= 0xD0 && marker <= 0xD9);
}

unsigned char byte_at(std::string_view file, std::size_t i) {
  return i < file.size() ? static_cast<unsigned char>(file[i]) : 0;
}

}  // namespace

std::size_t jpeg_scans(std::string_view file) {
  std::size_t scans = 0;
  for (std::size_t i = 0; (i = file.find('\xFF', i)) != file.npos;) {
    const unsigned char marker = byte_at(file, ++i);
    if (marker == kFill) continue;
    if (marker == kStartOfScan) ++scans;
    ++i;
    if (!stands_alone(marker))
      i += std::max(2U, unsigned{byte_at(file, i)} * 256 + byte_at(file, i + 1));
  }
  return scans;
}

void check_jpeg_scans(std::string_view file, long pixels) {
  const std::size_t scans = jpeg_scans(file);
  const std::size_t most =
      std::min(kMostScans, kMostScannedPixels / static_cast<std::size_t>(std::max(1L, pixels)));
  if (scans > most)
    throw Error("the JPEG image has " + std::to_string(scans) + " scans, more than the " +
                std::to_string(most) +
                " that are read at its size; save it as one that is not progressive");
}

}  // namespace foldless
