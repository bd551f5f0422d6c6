// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "tests/support/patience.h"

namespace foldless::test {

/// When work was last kept: as a copy of what is not saved, in a folder of states, or in its file.
/// What has gone while the folders are listed does not count.
inline std::filesystem::file_time_type last_kept(const std::filesystem::path& states,
                                                 const std::filesystem::path& saved) {
  namespace fs = std::filesystem;
  std::error_code gone;
  const auto time_of = [&gone](const fs::path& file) {
    const fs::file_time_type time = fs::last_write_time(file, gone);
    return gone ? fs::file_time_type::min() : time;
  };
  fs::file_time_type last = time_of(saved);
  for (const auto& folder : fs::directory_iterator(states / "autosave", gone))
    for (const auto& entry : fs::directory_iterator(folder, gone))
      if (entry.path().filename().string().starts_with('0'))
        last = std::max(last, time_of(entry.path()));
  return last;
}

/// Waits until another program has kept its work three times more: a copy that is being written and
/// one that waits for it may be from before the call, but the third has all that was done by then.
/// False when that never comes.
inline bool is_kept_anew(const std::filesystem::path& states, const std::filesystem::path& saved) {
  auto last = last_kept(states, saved);
  for (int times = 0; times < 3; ++times) {
    const auto before = last;
    if (!comes_true([&] { return (last = last_kept(states, saved)) > before; })) return false;
  }
  return true;
}

}  // namespace foldless::test
