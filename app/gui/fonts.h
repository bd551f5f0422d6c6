// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <set>
#include <span>

namespace foldless {

/// The fonts of the interface, owned by the current ImGui context's atlas.
struct Fonts {
  ImFont* text = nullptr;   ///< 14.5 design pixels
  ImFont* bold = nullptr;   ///< section headings
  ImFont* small = nullptr;  ///< hints, axis numbers
  ImFont* title = nullptr;  ///< name of a dialog
  ImFont* icons = nullptr;  ///< see icons.h; 19 design pixels
  ImFont* small_icons = nullptr;
};

/// The characters of the interface's own words, which all of its fonts have: first and last of each
/// range, ended by 0 as ImGui wants it.
std::span<const ImWchar> interface_ranges();

/// Rasterises the fonts for `scale` framebuffer pixels a design pixel into the current context's
/// atlas, in place of what was there, with the characters of the interface and `more`, as far as a
/// font has them. The caller uploads the atlas. Throws Error when the fonts that are installed
/// beside the program are missing.
Fonts build_fonts(float scale, const std::set<char32_t>& more);

}  // namespace foldless
