// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data_path.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <string>
#include <system_error>

#include "core/error.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

fs::path folder_of_executable() {
  std::error_code unreadable;
  return fs::read_symlink("/proc/self/exe", unreadable).parent_path();
}

/// Of the program, or of the shared library that this code has become a part of.
fs::path folder_of_code() {
  Dl_info info{};
  const bool is_known = dladdr(reinterpret_cast<void*>(&folder_of_executable), &info) != 0;
  return is_known && info.dli_fname ? fs::path(info.dli_fname).parent_path() : fs::path();
}

}  // namespace

fs::path data_path(std::string_view relative) {
  const char* chosen = std::getenv("FOLDLESS_DATA_DIR");
  const std::array<fs::path, 5> roots{chosen ? fs::path(chosen) : fs::path(),
                                      folder_of_executable() / "../share/foldless",
                                      // from lib/python3/dist-packages/foldless
                                      folder_of_code() / "../../../../share/foldless",
                                      fs::path(FOLDLESS_SOURCE_DIR), fs::path(FOLDLESS_BUILT_DATA)};
  for (const fs::path& root : roots) {
    if (root.empty()) continue;
    std::error_code unreadable;
    fs::path candidate = (root / relative).lexically_normal();
    if (fs::exists(candidate, unreadable)) return candidate;
  }
  throw Error(
      "cannot find the program's data '" + std::string(relative) + "'; install it beside " +
      "the program (../share/foldless) or set FOLDLESS_DATA_DIR to the folder that holds it");
}

}  // namespace foldless
