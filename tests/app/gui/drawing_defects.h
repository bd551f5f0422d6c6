// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace foldless::test {

/// What is wrong with the panels that the current ImGui context drew last, in words: texts and
/// shapes that are cut by the rectangle they are drawn in, and texts that lie over each other.
/// What scrolls may be cut along that direction; popups, dialogs and messages may cover what is
/// below.
std::vector<std::string> drawing_defects();

}  // namespace foldless::test
