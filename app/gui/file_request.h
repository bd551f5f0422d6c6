// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace foldless {

/// A folder one click away.
struct Place {
  std::string label;
  std::filesystem::path folder;
};

/// What a user is asked for, in the desktop's dialog for files or in our own.
struct FileRequest {
  enum class Purpose { open, save };
  Purpose purpose = Purpose::open;
  std::string title;
  std::vector<std::string> extensions;  ///< `.json`; the first is added to a name that has none
  std::filesystem::path start;          ///< folder, or suggested file
  std::vector<Place> places;            ///< beside home
  std::function<void(const std::filesystem::path&)> chosen;
  std::function<void()> dismissed;  ///< may be empty
};

/// The name that is given to a file to be saved: with the request's first extension where the
/// typed one has none.
std::filesystem::path with_extension(const FileRequest& request, std::filesystem::path file);

}  // namespace foldless
