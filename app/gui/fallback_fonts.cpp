// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/fallback_fonts.h"

#include <memory>

#include "app/gui/fontconfig.h"

namespace foldless {
namespace {

/// Deletes what fontconfig gave away, by its own function for each type.
template <const auto& Destroy>
struct Destroyer {
  template <typename T>
  void operator()(T* given) const {
    Destroy(given);
  }
};
using Charset = std::unique_ptr<FcCharSet, Destroyer<FcCharSetDestroy>>;
using FontPattern = std::unique_ptr<FcPattern, Destroyer<FcPatternDestroy>>;
using Config = std::unique_ptr<FcConfig, Destroyer<FcConfigDestroy>>;

/// Takes the characters that a font has out of `missing`.
std::set<char32_t> take_covered(FcPattern* font, std::set<char32_t>& missing) {
  std::set<char32_t> covered;
  FcCharSet* charset = nullptr;
  if (!font || FcPatternGetCharSet(font, FC_CHARSET, 0, &charset) != FcResultMatch) return covered;
  for (const char32_t character : missing)
    if (FcCharSetHasChar(charset, character)) covered.insert(character);
  for (const char32_t character : covered) missing.erase(character);
  return covered;
}

/// The outline font of the system that has the most of the characters, or null.
FontPattern best_of_system(FcConfig* config, const std::set<char32_t>& missing) {
  const Charset charset(FcCharSetCreate());
  for (const char32_t character : missing) FcCharSetAddChar(charset.get(), character);
  const FontPattern wanted(FcPatternCreate());
  FcPatternAddCharSet(wanted.get(), FC_CHARSET, charset.get());
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_COLOR, FcFalse);
  FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  return FontPattern(FcFontMatch(config, wanted.get(), &result));
}

/// False for fonts whose glyphs are pictures: a match is the nearest there is.
bool has_outlines(FcPattern* font) {
  FcBool is_outline = FcFalse, is_colour = FcFalse;
  FcPatternGetBool(font, FC_OUTLINE, 0, &is_outline);
  FcPatternGetBool(font, FC_COLOR, 0, &is_colour);
  return is_outline && !is_colour;
}

}  // namespace

std::vector<FallbackFont> fonts_for(std::set<char32_t> characters,
                                    const std::vector<std::filesystem::path>& own) {
  std::vector<FallbackFont> fonts;
  for (const auto& file : own) {
    int faces = 0;
    const FontPattern font(
        FcFreeTypeQuery(reinterpret_cast<const FcChar8*>(file.c_str()), 0, nullptr, &faces));
    auto covered = take_covered(font.get(), characters);
    if (!covered.empty()) fonts.push_back({file, 0, std::move(covered)});
  }
  if (characters.empty()) return fonts;
  // A configuration of our own leaves nothing behind when it goes.
  const Config config(FcInitLoadConfigAndFonts());
  while (config && !characters.empty()) {
    const FontPattern font = best_of_system(config.get(), characters);
    FcChar8* file = nullptr;
    int index = 0;
    if (!font || !has_outlines(font.get()) ||
        FcPatternGetString(font.get(), FC_FILE, 0, &file) != FcResultMatch)
      break;
    FcPatternGetInteger(font.get(), FC_INDEX, 0, &index);
    auto covered = take_covered(font.get(), characters);
    if (covered.empty()) break;
    fonts.push_back({reinterpret_cast<const char*>(file), index & 0xFFFF, std::move(covered)});
  }
  return fonts;
}

}  // namespace foldless
