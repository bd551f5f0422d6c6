// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace foldless::test {

/// Pictures of the time line and what comes out of it, at 100 and 200 percent, for looking at.
void draw_time_line(const std::filesystem::path& folder);

}  // namespace foldless::test
