// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// One row of the file browser.
struct DirectoryEntry {
  std::string name;
  bool is_folder = false;
  std::uintmax_t bytes = 0;  ///< size of a file
};

/// What a folder holds: folders first, then files, by name; or why it cannot be read.
struct DirectoryListing {
  std::filesystem::path folder;
  std::vector<DirectoryEntry> entries;
  std::string error;  ///< one sentence, empty when the folder was read
};

/// Lists folders and the files whose extension (`.json`, lower case) is among `extensions`; every
/// file when there are none. Names that begin with a dot are left out.
DirectoryListing list_directory(const std::filesystem::path& folder,
                                std::span<const std::string> extensions);

/// An ASCII letter in lower case, anything else as it is.
char lower_case(char c);

/// True when every letter of `filter` occurs in `name` in that order, upper or lower case.
bool matches_filter(std::string_view name, std::string_view filter);

/// The path that a user typed: `~` is the home folder, a relative path starts at `folder`.
std::filesystem::path typed_path(std::string_view text, const std::filesystem::path& folder);

/// Makes a folder. Returns why that failed, in one sentence that has the name; empty when it is
/// made.
std::string make_folder(const std::filesystem::path& parent, const std::string& name);

/// `4.2 kB`, `17 MB`.
std::string words_for_bytes(std::uintmax_t bytes);

}  // namespace foldless
