// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace foldless {

/// Removes a hidden file or folder that a process left which was killed. Who works on one holds its
/// lock (flock). False where it stays: somebody has it, or nobody can tell.
bool remove_left_over(const std::filesystem::path& path);

/// Locks what was just made under a name. False where another process has taken it for a leftover
/// meanwhile, and it is to be made again; true where the file system has no locks.
bool lock_new(int descriptor, const std::filesystem::path& path);

}  // namespace foldless
