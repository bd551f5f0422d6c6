// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/fonts.h"

#include <array>
#include <cmath>
#include <string>

namespace foldless {
namespace {

// Latin, Greek, punctuation, sub- and superscripts, arrows, mathematics, keys, shapes.
constexpr std::array<ImWchar, 19> kGlyphs{0x20,   0xFF,   0x370,  0x3FF,  0x2000, 0x20A0, 0x2190,
                                          0x21FF, 0x2200, 0x22FF, 0x2300, 0x23FF, 0x25A0, 0x25FF,
                                          0x2700, 0x27BF, 0x1D62, 0x1D62, 0};
// What Inter lacks and DejaVu Sans has: ∇ and a few shapes.
constexpr std::array<ImWchar, 7> kBorrowedGlyphs{0x2207, 0x2207, 0x25A0, 0x25FF, 0x2700, 0x27BF, 0};

std::optional<std::filesystem::path> first_existing(std::initializer_list<const char*> names) {
  for (const char* folder :
       {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/inter",
        "/usr/share/fonts/inter", "/usr/local/share/fonts/inter",
        "/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu"}) {
    for (const char* name : names) {
      std::error_code ignored;
      const auto path = std::filesystem::path(folder) / name;
      if (std::filesystem::is_regular_file(path, ignored)) return path;
    }
  }
  return std::nullopt;
}

ImFont* add_font(const std::optional<std::filesystem::path>& file, float pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  if (!file) {
    config.SizePixels = std::round(pixels * 13.0F / 14.5F);
    return atlas.AddFontDefault(&config);
  }
  ImFont* font = atlas.AddFontFromFileTTF(file->c_str(), pixels, &config, kGlyphs.data());
  if (const auto other = first_existing({"DejaVuSans.ttf"})) {
    config.MergeMode = true;
    atlas.AddFontFromFileTTF(other->c_str(), pixels, &config, kBorrowedGlyphs.data());
  }
  return font;
}

}  // namespace

std::optional<std::filesystem::path> find_interface_font(bool semi_bold) {
  return semi_bold
             ? first_existing({"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "DejaVuSans-Bold.ttf"})
             : first_existing({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"});
}

Fonts build_fonts(float scale) {
  ImGui::GetIO().Fonts->Clear();
  const auto regular = find_interface_font(false);
  const auto semi_bold = find_interface_font(true);
  Fonts fonts;
  fonts.text = add_font(regular, std::round(14.5F * scale));
  fonts.bold = add_font(semi_bold, std::round(14.5F * scale));
  fonts.small = add_font(regular, std::round(12.5F * scale));
  fonts.title = add_font(semi_bold, std::round(19.0F * scale));
  return fonts;
}

}  // namespace foldless
