// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// A file of a group, by its name in their folder.
struct NamedBytes {
  std::string name;
  std::string bytes;
};

/// Replaces files of one folder as a whole: `main`, which refers to the others, and those, which
/// lie beside it. They are written into a hidden folder; its renaming to `.NAME.foldless-committed`
/// makes them the result. Then the old main file goes, the others take their names, and the new
/// main file is the last: where there is a main file, all that it refers to is its own. What a
/// process that is killed in between leaves is brought to its end by the next that writes the
/// group. Throws Error; the old files are whole then, or the hidden folder has the new ones.
void write_files_together(const std::filesystem::path& main, const std::string& bytes,
                          const std::vector<NamedBytes>& others);

}  // namespace foldless
