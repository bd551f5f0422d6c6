// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// The names of all that is in a folder, hidden ones too, in no order; none where it cannot be
/// read. (Where memory is short std::filesystem's iterators end the program.)
std::vector<std::string> names_in_folder(const std::filesystem::path& folder);

/// The same for those to whom a name that is not found is one that is not there. Throws Error where
/// the folder is there but cannot be read to its end.
std::vector<std::string> all_names_in_folder(const std::filesystem::path& folder);

}  // namespace foldless
