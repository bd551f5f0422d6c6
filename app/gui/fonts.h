// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>

namespace foldless {

/// The fonts of the interface, owned by the current ImGui context's atlas.
struct Fonts {
  ImFont* text = nullptr;   ///< 14.5 design pixels
  ImFont* bold = nullptr;   ///< section headings
  ImFont* small = nullptr;  ///< hints, axis numbers
  ImFont* title = nullptr;  ///< name of a dialog
};

/// The installed file of Inter (or DejaVu Sans) for that weight, `Regular` or `SemiBold`; nothing
/// when neither font is installed.
std::optional<std::filesystem::path> find_interface_font(bool semi_bold);

/// Rasterises the fonts for `scale` framebuffer pixels a design pixel into the current context's
/// atlas, in place of what was there. Falls back on ImGui's own font. The caller uploads the atlas.
Fonts build_fonts(float scale);

}  // namespace foldless
