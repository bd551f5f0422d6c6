// SPDX-License-Identifier: GPL-3.0-or-later
// Every character that is shown has a glyph: in the program's own words whatever fonts the system
// has, and in names of files in any script that one of its fonts knows.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "app/editor/edits.h"
#include "app/gui/fallback_fonts.h"
#include "app/gui/fonts.h"
#include "core/data_path.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

const std::string kCyrillic = "Лиса";
const std::string kGreekAndVietnamese = "Ἀλώπηξ cáo đỏ ế";
const std::string kChinese = "狐狸", kChineseAndJapanese = kChinese + " キツネ";

std::set<char32_t> characters_of(std::string_view text) {
  std::set<char32_t> characters;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end) {
    unsigned int character = 0;
    at += ImTextCharFromUtf8(&character, at, end);
    characters.insert(character);
  }
  return characters;
}

/// Not one of icons.
bool has_words(const ImFont& font) { return font.FindGlyphNoFallback('A') != nullptr; }

/// The first character of a text that a font of the current context lacks, or nothing.
std::string first_missing(std::string_view text) {
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const char32_t character : characters_of(text)) {
    if (character < 0x20) continue;
    for (const ImFont* font : atlas.Fonts)
      if (has_words(*font) && !font->FindGlyphNoFallback(static_cast<ImWchar>(character))) {
        char words[5] = {};
        ImTextCharToUtf8(words, character);
        return words;
      }
  }
  return "";
}

/// What stands between quotation marks in a source file, comments aside.
std::string literals_of(const std::filesystem::path& source) {
  std::ifstream file(source);
  std::string literals;
  for (std::string line; std::getline(file, line);) {
    bool is_inside = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (!is_inside && line.compare(i, 2, "//") == 0) break;
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == '"') {
        is_inside = !is_inside;
      } else if (is_inside) {
        literals += line[i];
      }
    }
  }
  return literals;
}

/// A system without any font.
class NoFonts {
 public:
  NoFonts() {
    write_file_atomically(folder_ / "fonts.conf",
                          "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">"
                          "<fontconfig><cachedir>" +
                              (folder_ / "cache").string() + "</cachedir></fontconfig>");
    setenv("FONTCONFIG_FILE", (folder_ / "fonts.conf").c_str(), 1);
  }
  ~NoFonts() { unsetenv("FONTCONFIG_FILE"); }
  NoFonts(const NoFonts&) = delete;
  NoFonts& operator=(const NoFonts&) = delete;

 private:
  TemporaryFolder folder_;
};

TEST(OwnWords, HaveAllTheirGlyphsOnASystemWithoutFonts) {
  const NoFonts none;
  HeadlessEditor headless;
  std::size_t literals = 0;
  for (const char* room : {"app", "core", "render"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(data_path("app").parent_path() / room)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      const std::string words = literals_of(entry.path());
      literals += words.size();
      EXPECT_EQ(first_missing(words), "") << entry.path();
    }
  EXPECT_GT(literals, 10000U);
}

TEST(FontsFor, TakesItsOwnFontsFirstThenTheSystems) {
  const auto inter = data_path("fonts/Inter-Regular.otf");
  const auto fonts = fonts_for(characters_of(kCyrillic + kChinese), {inter});
  ASSERT_EQ(fonts.size(), 2U);
  EXPECT_EQ(fonts[0].file, inter);
  EXPECT_EQ(fonts[0].characters, characters_of(kCyrillic));
  EXPECT_EQ(fonts[1].characters, characters_of(kChinese));
}

TEST(FontsFor, GivesUpWhereNoFontHasTheCharacter) {
  const NoFonts none;
  EXPECT_TRUE(fonts_for(characters_of(kChinese), {}).empty());
}

class Names : public testing::TestWithParam<std::string> {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path save_bar(const std::string& name) const {
    const Shape shape = bar(4, 1, 2);
    write_mesh(folder_ / (name + ".obj"), shape.triangles, shape.rest);
    return folder_ / (name + ".obj");
  }
};

TEST_P(Names, OfAnOpenFileHaveTheirGlyphs) {
  HeadlessEditor headless;
  EXPECT_NE(first_missing(GetParam()), "");
  headless.editor().files().open(save_bar(GetParam()));
  headless.settle();
  EXPECT_EQ(first_missing(GetParam()), "");
}

TEST_P(Names, InTheFileBrowserHaveTheirGlyphs) {
  HeadlessEditor headless;
  const auto folder = save_bar(GetParam()).parent_path();
  headless.key(Key::o, kControl);
  headless.type(folder.string());
  headless.key(Key::enter);
  headless.settle();
  EXPECT_EQ(first_missing(GetParam()), "");
}

TEST_P(Names, ThatAreTypedHaveTheirGlyphs) {
  HeadlessEditor headless;
  for (const char32_t character : characters_of(GetParam()))
    headless.ui().receive(CharacterTyped{character});
  headless.settle();
  EXPECT_EQ(first_missing(GetParam()), "");
}

TEST_P(Names, SurviveAChangeOfScale) {
  HeadlessEditor headless;
  headless.editor().files().open(save_bar(GetParam()));
  headless.settle();
  headless.ui().settings().scale = 1.5;
  headless.settle();
  EXPECT_EQ(first_missing(GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(InEveryScript, Names,
                         testing::Values(kCyrillic, kGreekAndVietnamese, kChineseAndJapanese));

TEST(NamesInNoScript, WithCharactersThatNoFontHasAreNoErrors) {
  const NoFonts none;
  HeadlessEditor headless;
  headless.editor().files().open_shape(bar(4, 1, 2), kChinese);
  headless.settle();
  EXPECT_NE(first_missing(kChinese), "");
  EXPECT_EQ(first_missing("no error"), "");
}

TEST(NamesInNoScript, ThatAreNoUtf8DoNoHarm) {
  HeadlessEditor headless;
  headless.editor().files().open_shape(bar(4, 1, 2), "\xff\xfe broken \xc3");
  headless.settle();
  EXPECT_EQ(first_missing("broken"), "");
}

}  // namespace
}  // namespace foldless::test
