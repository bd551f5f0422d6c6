// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace foldless::test {

/// What is wrong with the panels that the current ImGui context drew last, in words: texts and
/// shapes that are cut by the rectangle they are drawn in, and texts that lie over each other.
/// What scrolls may be cut along that direction; popups, dialogs and messages may cover what is
/// below.
std::vector<std::string> drawing_defects();

/// The middle of a text that was drawn last, in framebuffer pixels: of the topmost one with these
/// words, if there is any.
std::optional<ImVec2> place_of_words(const std::string& words);

}  // namespace foldless::test
