// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace foldless {

/// The file or folder `relative` ("shaders", "assets/scenes/bar.json") among the program's data:
/// the first that exists of $FOLDLESS_DATA_DIR/relative, ../share/foldless/relative as seen from
/// the executable, the same of the prefix that the Python package lies in, the tree that the
/// program was built from, and what its build put together
/// ("fonts"). Throws Error when none does.
std::filesystem::path data_path(std::string_view relative);

}  // namespace foldless
