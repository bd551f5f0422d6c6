// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace foldless {

/// The bytes of a file that the program wrote for itself: settings, lists. Empty where there is
/// none, it cannot be read, is no regular file (a pipe would be waited for), or has more than 1
/// MiB.
std::string read_small_file(const std::filesystem::path& file);
/// The same, but throws Error where there is one that cannot be read.
std::string small_file(const std::filesystem::path& file);

}  // namespace foldless
