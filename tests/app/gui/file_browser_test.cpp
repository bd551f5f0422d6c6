// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and saving through the file browser, by mouse and keys: files and pixels.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cstring>
#include <string_view>

#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "render/image_difference.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/rasterised.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

constexpr Modifiers kCtrl{.control = true};
constexpr Modifiers kCtrlShift{.shift = true, .control = true};

/// A window of the interface by a part of its name, or null.
const ImGuiWindow* window_named(std::string_view part) {
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
    if (window->WasActive && std::string_view(window->Name).find(part) != std::string_view::npos)
      return window;
  return nullptr;
}

class FileBrowserTest : public testing::Test {
 protected:
  FileBrowserTest() {
    const Shape shape = bar(4, 1, 2);
    write_mesh(folder_ / "bar.obj", shape.triangles, shape.rest);
    std::filesystem::create_directory(folder_ / "empty");
    open_bar();
  }

  Editor& editor() { return headless_.editor(); }
  void open_bar() {
    editor().files().open(folder_ / "bar.obj");
    headless_.calm_down();
  }
  static bool is_open() { return window_named("##file browser") != nullptr; }
  void type(std::string_view text) {
    for (const char c : text) headless_.ui().receive(CharacterTyped{static_cast<char32_t>(c)});
    headless_.settle();
  }
  void retype(const std::filesystem::path& text) {
    headless_.key(Key::a, kCtrl);
    type(text.string());
  }
  /// In the dialog that saves, with a name typed.
  void ask_to_save(const std::filesystem::path& file) {
    headless_.key(Key::s, kCtrlShift);
    ASSERT_TRUE(is_open());
    retype(file);
  }
  /// In a dialog that stands in a folder.
  void go_to(const std::filesystem::path& folder) {
    retype(folder);
    headless_.key(Key::enter);
  }
  void click_row(int row) {
    const ImGuiWindow* list = window_named("/entries_");
    ASSERT_NE(list, nullptr);
    headless_.click({list->Pos.x + 40, list->Pos.y + 16 + static_cast<float>(row) * 20});
  }
  /// Differing pixels in the list of files.
  int differing_in_list(const Image& a, const Image& b) {
    const ImGuiWindow* list = window_named("/entries_");
    int count = 0;
    for (int y = 0; y < static_cast<int>(list->Size.y); ++y)
      for (int x = 0; x < static_cast<int>(list->Size.x); ++x) {
        const int u = static_cast<int>(list->Pos.x) + x, v = static_cast<int>(list->Pos.y) + y;
        count += std::memcmp(a.at(u, v), b.at(u, v), 4) != 0;
      }
    return count;
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(FileBrowserTest, EnterOpensTheRowThatWasClicked) {
  editor().files().new_document();
  headless_.key(Key::o, kCtrl);
  go_to(folder_.path());
  ASSERT_TRUE(is_open());
  click_row(1);
  headless_.key(Key::enter);
  EXPECT_FALSE(is_open());
  EXPECT_EQ(editor().document().name, "bar");
}

TEST_F(FileBrowserTest, EnterSavesUnderTheNameThatWasClickedAndRReplacesIt) {
  const auto file = folder_.write("scene.json", "old");
  ask_to_save(folder_.path());
  headless_.key(Key::enter);
  click_row(1);
  headless_.key(Key::enter);
  EXPECT_TRUE(is_open()) << "the question";
  EXPECT_EQ(read_file(file), "old");
  headless_.key(Key::enter);
  EXPECT_EQ(read_file(file), "old") << "Enter keeps what is there";
  headless_.key(Key::enter);
  headless_.key(Key::escape);
  EXPECT_TRUE(is_open()) << "Esc closes the question alone";
  headless_.key(Key::enter);
  headless_.key(Key::r);
  EXPECT_FALSE(is_open());
  EXPECT_NE(read_file(file), "old");
}

TEST_F(FileBrowserTest, ArrowsChooseNamesAndFoldersWhenSaving) {
  const auto file = folder_.write("scene.json", "old");
  ask_to_save(folder_.path());
  headless_.key(Key::enter);
  type("new");
  headless_.key(Key::down);
  headless_.key(Key::enter);
  headless_.key(Key::enter);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "empty/new.json")) << "the name is kept";
  ask_to_save(folder_.path());
  headless_.key(Key::enter);
  headless_.key(Key::down);
  headless_.key(Key::down);
  headless_.key(Key::enter);
  headless_.key(Key::r);
  EXPECT_NE(read_file(file), "old");
}

TEST_F(FileBrowserTest, ASaveThatFailsKeepsTheNameAndSaysWhy) {
  const auto blocker = folder_.write("blocker", "a file, no folder");
  ask_to_save(blocker / "scene.json");
  const Image before = headless_.picture();
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  EXPECT_GT(differing_pixels(before, headless_.picture()), 300) << "the reason";
  std::filesystem::remove(blocker);
  std::filesystem::create_directory(blocker);
  headless_.key(Key::enter);
  EXPECT_FALSE(is_open());
  EXPECT_TRUE(std::filesystem::exists(blocker / "scene.json"));
}

TEST_F(FileBrowserTest, QuittingWaitsUntilTheFileIsSaved) {
  const auto blocker = folder_.write("blocker", "a file, no folder");
  headless_.click(headless_.window_point({0, 0.5}));
  headless_.key(Key::q, kCtrl);
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  retype(blocker / "scene.json");
  headless_.key(Key::enter);
  EXPECT_FALSE(headless_.ui().wants_to_quit());
  ASSERT_TRUE(is_open());
  retype(folder_ / "scene.json");
  headless_.key(Key::enter);
  EXPECT_TRUE(headless_.ui().wants_to_quit());
}

TEST_F(FileBrowserTest, AnExportThatFailsAsksAgain) {
  const auto blocker = folder_.write("blocker", "a file, no folder");
  headless_.key(Key::e, kCtrl);
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  retype(blocker / "shot.png");
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  std::filesystem::remove(blocker);
  std::filesystem::create_directory(blocker);
  headless_.key(Key::enter);
  EXPECT_FALSE(is_open());
  EXPECT_TRUE(std::filesystem::exists(blocker / "shot.png"));
}

TEST_F(FileBrowserTest, WhatWasWrittenIsSaidOnScreenThoughNothingElseHappens) {
  headless_.key(Key::e, kCtrl);
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  retype(folder_ / "shot.png");
  headless_.key(Key::enter);
  EXPECT_TRUE(headless_.find_words("Wrote " + (folder_ / "shot.png").string()));
}

TEST_F(FileBrowserTest, APictureIsExportedInAnySize) {
  headless_.key(Key::e, kCtrl);
  const Vec2 width{399, 294}, height{481, 294};
  for (const auto& [field, pixels] : {std::pair{width, "300"}, std::pair{height, "120"}}) {
    headless_.click(field);
    headless_.key(Key::a, kCtrl);
    headless_.type(pixels);
    headless_.key(Key::enter);
  }
  headless_.key(Key::enter);
  ASSERT_TRUE(is_open());
  retype(folder_ / "wide.png");
  headless_.key(Key::enter);
  const Image picture = load_image(folder_ / "wide.png");
  EXPECT_EQ(picture.width, 300);
  EXPECT_EQ(picture.height, 120);
}

TEST_F(FileBrowserTest, TheCanvasIsExportedAsAFigureInTheBackground) {
  const Image canvas = headless_.canvas_picture();
  for (const auto& [format, name] :
       {std::pair{Vec2{392, 188}, "a.svg"}, {Vec2{488, 188}, "b.pdf"}}) {
    headless_.key(Key::e, kCtrl);
    headless_.click(format);
    headless_.key(Key::enter);
    ASSERT_TRUE(is_open());
    retype(folder_ / name);
    headless_.key(Key::enter);
    EXPECT_FALSE(is_open());
    ASSERT_TRUE(headless_.wait_until([&] { return !headless_.ui().is_exporting(); }));
    ASSERT_TRUE(std::filesystem::exists(folder_ / name));
  }
  const auto drawn = rasterised(VectorFormat::svg, read_file(folder_ / "a.svg"));
  if (!drawn) GTEST_SKIP() << "librsvg2-bin is missing";
  ASSERT_EQ(drawn->width, canvas.width);
  EXPECT_LT(difference_of(canvas, *drawn, 64).mean, 1);
}

TEST_F(FileBrowserTest, AFigureThatCannotBeWrittenAsksForAnotherName) {
  const auto blocker = folder_.write("blocker", "a file, no folder");
  headless_.key(Key::e, kCtrl);
  headless_.click({392, 188});
  headless_.key(Key::enter);
  retype(blocker / "figure.svg");
  headless_.key(Key::enter);
  EXPECT_TRUE(is_open());
  std::filesystem::remove(blocker);
  std::filesystem::create_directory(blocker);
  headless_.key(Key::enter);
  EXPECT_TRUE(std::filesystem::exists(blocker / "figure.svg"));
}

TEST_F(FileBrowserTest, AnEmptyFolderIsNoReasonNotToSaveThere) {
  headless_.key(Key::o, kCtrl);
  go_to(folder_ / "empty");
  const Image opening = headless_.picture();
  headless_.key(Key::escape);
  ask_to_save(folder_ / "empty");
  headless_.key(Key::enter);
  EXPECT_GT(differing_in_list(opening, headless_.picture()), 50) << "other words than for opening";
}

TEST_F(FileBrowserTest, MakesANewFolderToSaveIn) {
  ask_to_save(folder_.path());
  headless_.key(Key::enter);
  type("scene");
  headless_.key(Key::n, kCtrlShift);
  type("dropped");
  headless_.key(Key::escape);
  ASSERT_TRUE(is_open()) << "Esc closes the question for the folder's name alone";
  headless_.key(Key::n, kCtrlShift);
  type("empty");
  headless_.key(Key::enter);
  EXPECT_NE(window_named("##new folder"), nullptr) << "there is one already";
  retype("poses");
  headless_.key(Key::enter);
  EXPECT_EQ(window_named("##new folder"), nullptr);
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "poses"));
  headless_.key(Key::enter);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "poses/scene.json"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "dropped"));
}

TEST_F(FileBrowserTest, DeletingTheLastLetterStaysInTheFolder) {
  editor().files().new_document();
  headless_.key(Key::o, kCtrl);
  go_to(folder_.path());
  type("b");
  headless_.key(Key::backspace);
  click_row(1);
  headless_.key(Key::enter);
  EXPECT_EQ(editor().document().name, "bar");
}

}  // namespace
}  // namespace foldless::test
