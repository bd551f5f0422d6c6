// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// The file of a solved folder that tells which other files of it `solve` wrote.
inline constexpr const char* kManifest = "manifest.json";

/// A file that `solve` wrote. It is still the program's own where name, size and CRC are these.
struct ResultFile {
  std::string name;  ///< within the folder, such as `frames/000000.obj`
  std::uintmax_t bytes = 0;
  std::uint32_t crc = 0;  ///< CRC-32

  bool operator==(const ResultFile&) const = default;
};

using Manifest = std::vector<ResultFile>;

/// True for the names that `solve` gives to files, the manifest among them.
bool is_result_name(const std::string& name);

/// The entry that a manifest of `folder` has for a file; nothing where `name` is no regular file,
/// or one of another folder that is reached through a symbolic link.
std::optional<ResultFile> entry_of(const std::filesystem::path& folder, const std::string& name);

/// The manifest of a folder; empty when there is none. Throws Error for one that `solve` did not
/// write.
Manifest read_manifest(const std::filesystem::path& folder);

/// The text of manifest.json.
std::string text_of(const Manifest& manifest);

}  // namespace foldless
