// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/fonts.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/gui/fallback_fonts.h"
#include "app/gui/icons.h"
#include "core/data_path.h"
#include "core/error.h"
#include "core/files/atomic_file.h"

namespace foldless {
namespace {

// Latin, Greek, punctuation, sub- and superscripts, arrows, mathematics, keys, shapes, and what
// stands for a character that no font has.
constexpr std::array<ImWchar, 21> kGlyphs{0x20,   0xFF,   0x370,  0x3FF,  0x2000, 0x20A0, 0x2190,
                                          0x21FF, 0x2200, 0x22FF, 0x2300, 0x23FF, 0x25A0, 0x25FF,
                                          0x2700, 0x27BF, 0x1D62, 0x1D62, 0xFFFD, 0xFFFD, 0};
// What Inter lacks and DejaVu Sans has: ∇ and a few shapes.
constexpr std::array<ImWchar, 7> kBorrowedGlyphs{0x2207, 0x2207, 0x25A0, 0x25FF, 0x2700, 0x27BF, 0};

/// Puts fonts into the atlas, and holds what ImGui wants to find until the atlas is built.
class AtlasBuilder {
 public:
  explicit AtlasBuilder(const std::set<char32_t>& more) {
    for (const auto& file : {regular_, semi_bold_, borrowed_, icons_})
      data_[file] = read_file(file);
    if (more.empty()) return;
    for (const FallbackFont& font : fonts_for(more, {regular_, borrowed_})) add_extra(font);
  }

  Fonts add_all(float scale) {
    Fonts fonts;
    fonts.text = add(regular_, std::round(14.5F * scale));
    fonts.bold = add(semi_bold_, std::round(14.5F * scale));
    fonts.small = add(regular_, std::round(12.5F * scale));
    fonts.title = add(semi_bold_, std::round(19.0F * scale));
    fonts.icons = add({icons_, 0, icon_ranges().data()}, std::round(19.0F * scale));
    fonts.small_icons = add({icons_, 0, icon_ranges().data()}, std::round(16.0F * scale));
    return fonts;
  }

 private:
  struct Extra {
    std::filesystem::path file;
    int index = 0;
    std::vector<ImWchar> ranges;
  };

  /// A font of the system that cannot be read is as good as none.
  void add_extra(const FallbackFont& font) {
    try {
      if (!data_.contains(font.file)) data_[font.file] = read_file(font.file);
    } catch (const Error&) {
      return;
    }
    Extra& extra = extras_.emplace_back(Extra{font.file, font.index, {}});
    for (const char32_t character : font.characters)
      extra.ranges.insert(extra.ranges.end(), 2, static_cast<ImWchar>(character));
    extra.ranges.push_back(0);
  }

  ImFont* add(const std::filesystem::path& file, float pixels) {
    ImFont* font = add({file, 0, kGlyphs.data()}, pixels);
    add({borrowed_, 0, kBorrowedGlyphs.data(), true}, pixels);
    for (const Extra& extra : extras_)
      add({extra.file, extra.index, extra.ranges.data(), true}, pixels);
    return font;
  }

  /// Some characters of a face of a font file.
  struct Part {
    const std::filesystem::path& file;
    int index = 0;
    const ImWchar* ranges = nullptr;
    bool merges = false;  ///< into the font that was added last
  };
  ImFont* add(const Part& part, float pixels) {
    std::string& data = data_.at(part.file);
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.FontNo = part.index;
    config.MergeMode = part.merges;
    config.FontDataOwnedByAtlas = false;
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data.data(), static_cast<int>(data.size()),
                                                      pixels, &config, part.ranges);
  }

  std::filesystem::path regular_ = data_path("fonts/Inter-Regular.otf");
  std::filesystem::path semi_bold_ = data_path("fonts/Inter-SemiBold.otf");
  std::filesystem::path borrowed_ = data_path("fonts/DejaVuSans.ttf");
  std::filesystem::path icons_ = data_path("fonts/materialdesignicons-webfont.ttf");
  std::vector<Extra> extras_;
  std::map<std::filesystem::path, std::string> data_;  ///< what the files hold
};

}  // namespace

std::span<const ImWchar> interface_ranges() { return kGlyphs; }

Fonts build_fonts(float scale, const std::set<char32_t>& more) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  AtlasBuilder builder(more);
  Fonts fonts = builder.add_all(scale);
  if (!atlas.Build() && !more.empty()) return build_fonts(scale, {});  // a broken font file
  atlas.ClearInputData();
  return fonts;
}

}  // namespace foldless
