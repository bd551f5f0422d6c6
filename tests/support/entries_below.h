// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace foldless::test {

/// All files and folders in a folder and in its folders. Other threads may change them meanwhile:
/// what has gone while they are listed does not count, where std's own recursive iterator throws.
inline std::vector<std::filesystem::path> entries_below(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> entries;
  std::error_code gone;
  for (fs::directory_iterator it(folder, gone); !gone && it != fs::directory_iterator();
       it.increment(gone)) {
    entries.push_back(it->path());
    std::error_code unknown;
    if (!it->is_directory(unknown)) continue;
    const std::vector<fs::path> inner = entries_below(it->path());
    entries.insert(entries.end(), inner.begin(), inner.end());
  }
  return entries;
}

}  // namespace foldless::test
