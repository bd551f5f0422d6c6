// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/small_file.h"

#include <system_error>

#include "core/error.h"
#include "core/files/atomic_file.h"

namespace foldless {

std::string small_file(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMostBytesOfSmall = 1 << 20;
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return {};
  if (std::filesystem::file_size(file, failure) > kMostBytesOfSmall || failure) return {};
  return read_file(file);
}

std::string read_small_file(const std::filesystem::path& file) {
  try {
    return small_file(file);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace foldless
