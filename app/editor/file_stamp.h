// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace foldless {

/// By which it is seen that a file has changed.
struct FileStamp {
  std::filesystem::file_time_type time;
  std::uintmax_t size = 0;

  bool operator==(const FileStamp&) const = default;
};

/// Nothing where there is no such file.
inline std::optional<FileStamp> stamp_of(const std::filesystem::path& file) {
  std::error_code missing, unknown;
  const FileStamp stamp{std::filesystem::last_write_time(file, missing),
                        std::filesystem::file_size(file, unknown)};
  if (missing || unknown) return std::nullopt;
  return stamp;
}

}  // namespace foldless
