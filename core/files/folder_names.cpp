// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/folder_names.h"

#include <dirent.h>

#include <cerrno>
#include <memory>
#include <string_view>
#include <system_error>

#include "core/error.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

/// 0, or what went wrong.
int list(const fs::path& folder, std::vector<std::string>& names) {
  const std::unique_ptr<DIR, CloseFolder> open(::opendir(folder.c_str()));
  if (!open) return errno;
  for (;;) {
    errno = 0;
    const dirent* entry = ::readdir(open.get());
    if (!entry) return errno;
    if (const std::string_view name = entry->d_name; name != "." && name != "..")
      names.emplace_back(name);
  }
}

}  // namespace

std::vector<std::string> names_in_folder(const fs::path& folder) {
  std::vector<std::string> names;
  list(folder, names);
  return names;
}

std::vector<std::string> all_names_in_folder(const fs::path& folder) {
  std::vector<std::string> names;
  const int error = list(folder, names);
  if (error != 0 && error != ENOENT)
    throw Error(folder.string() + ": cannot be read: " + std::generic_category().message(error));
  return names;
}

}  // namespace foldless
