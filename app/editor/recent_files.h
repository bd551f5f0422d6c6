// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace foldless {

/// The ten files that were opened or saved last, newest first, kept on disk as JSON.
class RecentFiles {
 public:
  /// Reads the list; what cannot be read counts as empty. An empty path keeps nothing on disk.
  explicit RecentFiles(std::filesystem::path file = {});

  const std::vector<std::filesystem::path>& paths() const { return paths_; }
  /// Puts a file in front and writes the list atomically. A list that cannot be written is kept in
  /// memory: it is a convenience.
  void add(const std::filesystem::path& path);
  void remove(const std::filesystem::path& path);

 private:
  void write() const;

  std::filesystem::path file_;
  std::vector<std::filesystem::path> paths_;
};

/// $XDG_STATE_HOME/foldless, or ~/.local/state/foldless; empty when neither is known.
std::filesystem::path default_state_folder();

}  // namespace foldless
