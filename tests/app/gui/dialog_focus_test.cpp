// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard in dialogs: Tab, Shift+Tab, Space and Enter, and the ring round what has the focus.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <vector>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

constexpr Modifiers kHeldShift{.shift = true};
constexpr std::size_t kMostControls = 40;

/// A control with the focus.
struct Stop {
  ImGuiID id = 0;
  ImRect place;
};

class DialogFocus : public testing::Test {
 protected:
  void open_bar() {
    editor().files().open_shape(bar(4, 1, 2), "bar");
    headless_.calm_down();
  }
  Editor& editor() { return headless_.editor(); }
  void run(std::string_view command) {
    editor().run_command(command);
    headless_.settle();
  }
  void search_and_run(std::string_view words) {
    headless_.key(Key::k, kControl);
    headless_.type(words);
    headless_.key(Key::enter);
  }
  Stop tab(Modifiers modifiers = {}) {
    headless_.key(Key::tab, modifiers);
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (!g.NavWindow) return {};
    return {g.NavId, ImGui::WindowRectRelToAbs(g.NavWindow, g.NavWindow->NavRectRel[g.NavLayer])};
  }
  /// Every control until the first one comes again.
  std::vector<Stop> round(Modifiers modifiers = {}) {
    std::vector<Stop> stops{tab(modifiers)};
    while (stops.size() < kMostControls) {
      const Stop next = tab(modifiers);
      if (next.id == stops.front().id) return stops;
      stops.push_back(next);
    }
    ADD_FAILURE() << "Tab does not come back";
    return stops;
  }
  /// `others`: controls without words on them.
  void expect_round(const std::vector<std::string>& words, std::size_t others) {
    std::vector<Stop> stops = round();
    EXPECT_EQ(stops.size(), words.size() + others);
    for (const std::string& word : words) {
      const auto place = headless_.find_words(word);
      ASSERT_TRUE(place) << word;
      const ImVec2 at{static_cast<float>(place->x()), static_cast<float>(place->y())};
      EXPECT_EQ(std::ranges::count_if(stops, [&at](const Stop& s) { return s.place.Contains(at); }),
                1)
          << word;
    }
    for (std::size_t i = 0; i < stops.size(); ++i)
      for (std::size_t k = i + 1; k < stops.size(); ++k) EXPECT_NE(stops[i].id, stops[k].id);
    tab();  // to the second one; back from there
    std::vector<Stop> back = round(kHeldShift);
    std::ranges::reverse(back);
    std::rotate(back.begin(), back.end() - 1, back.end());
    ASSERT_EQ(back.size(), stops.size());
    for (std::size_t i = 0; i < stops.size(); ++i) EXPECT_EQ(back[i].id, stops[i].id) << i;
  }
  void tab_to(const std::string& words) {
    const Vec2 place = headless_.find_words(words).value();
    for (std::size_t i = 0; i < kMostControls; ++i)
      if (tab().place.Contains({static_cast<float>(place.x()), static_cast<float>(place.y())}))
        return;
    FAIL() << words << " cannot be reached";
  }
  bool shows(const char* dialog) {
    const ImGuiWindow* window = ImGui::FindWindowByName(dialog);
    return window && window->WasActive;
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_{{1000, 800}, {}, {.state_folder = folder_.path() / "state"}};
};

TEST_F(DialogFocus, TabReachesEveryControlOfADocumentsDialogsOnceARound) {
  open_bar();
  {
    SCOPED_TRACE("export");
    run("file.export");
    expect_round({"PNG picture", "SVG figure", "PDF figure", "PNG sequence", "OBJ mesh", "OFF mesh",
                  "PLY mesh", "Any size", "Transparent background", "Choose a file…", "Cancel"},
                 3 + 2 + kLayerRows.size());
    headless_.key(Key::escape);
  }
  {
    SCOPED_TRACE("messages");
    search_and_run("help: messages");
    expect_round({"Copy all", "Close"}, 1);
    headless_.key(Key::escape);  // leaves the text
    headless_.key(Key::escape);
  }
  {
    SCOPED_TRACE("keys");
    search_and_run("edit: keys");
    headless_.click(headless_.find_words("Search by command or key").value());
    headless_.type("file: save as");
    expect_round({"Foldless", "Ctrl+Shift+S", "Close"}, 1);
    headless_.key(Key::escape);
  }
  {
    SCOPED_TRACE("unsaved changes");
    headless_.click(headless_.window_point({0, 0.5}));
    headless_.key(Key::q, kControl);
    expect_round({"Save", "Discard the changes", "Cancel"}, 0);
    headless_.key(Key::escape);
  }
}

TEST_F(DialogFocus, TabReachesEveryControlOfTheFileBrowserOnceARound) {
  open_bar();
  run("file.save_as");
  const std::filesystem::path here = std::filesystem::current_path();
  const auto folders = static_cast<std::size_t>(std::distance(here.begin(), here.end()));
  // Beside these the parent folder, the folders above, and the name of the file.
  expect_round({"New folder…", "Home", "Whole disk", "Save", "Cancel"}, 1 + folders + 1);
}

TEST_F(DialogFocus, TabReachesEveryControlOfTheQuestionsOfTheFileBrowserOnceARound) {
  folder_.write("old.json", "old");
  open_bar();
  run("file.save_as");
  headless_.key(Key::a, kControl);
  headless_.type((folder_ / "old.json").string());
  headless_.key(Key::enter);
  {
    SCOPED_TRACE("replace");
    expect_round({"Keep it", "Replace (R)"}, 0);
    headless_.key(Key::escape);
  }
  {
    SCOPED_TRACE("new folder");
    headless_.click(headless_.find_words("New folder…").value());
    expect_round({"Make it", "Cancel"}, 1);
    headless_.key(Key::escape);
  }
}

TEST_F(DialogFocus, TabReachesEveryControlOfAboutOnceARound) {
  search_and_run("about foldless");
  expect_round({"Close"}, 0);
}

TEST_F(DialogFocus, TabReachesEveryControlOfTheQuestionBeforeAnothersFileIsReplaced) {
  open_bar();
  ASSERT_TRUE(editor().files().save_as(folder_ / "bar.json"));
  headless_.click(headless_.window_point({0, 0.5}));
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  folder_.write("bar.json", "theirs");
  headless_.key(Key::s, kControl);
  expect_round({"Save as…", "Overwrite (O)", "Cancel"}, 0);
}

TEST_F(DialogFocus, TabReachesEveryControlOfTheRecoveryOnceARound) {
  {
    Editor lost({.state_folder = folder_.path() / "state"});
    lost.view().resize(400, 400, 1);
    lost.files().open_shape(bar(4, 1, 2), "bar");
    const Vec2 at = lost.canvas().to_pixel(lost.shown()->deformed.col(0));
    lost.receive(PointerPressed{Button::left, at, {}}, 0);
    lost.receive(PointerReleased{Button::left, at, {}}, 0);
    lost.files().rescue();
  }
  editor().files().recovery().find();
  ASSERT_TRUE(
      headless_.wait_until([this] { return editor().files().recovery().work() != nullptr; }));
  expect_round({"Restore", "Discard…", "Later"}, 0);
  headless_.click(headless_.find_words("Discard…").value());
  expect_round({"Keep it", "Discard"}, 0);
}

TEST_F(DialogFocus, TabReachesEveryControlOfAPicturesDialogOnceARound) {
  write_ring(folder_ / "ring.png", 128);
  editor().files().open(folder_ / "ring.png");
  ASSERT_TRUE(headless_.wait_until([this] { return editor().files().image_import().is_ready(); }));
  expect_round({"Coarse", "Medium", "Fine", "Make the mesh", "Cancel"}, 5);
}

TEST_F(DialogFocus, EnterPressesTheButtonWithTheFocusElseTheMainOne) {
  open_bar();
  run("file.export");
  tab_to("Cancel");
  headless_.key(Key::enter);
  EXPECT_FALSE(shows("##export"));
  EXPECT_FALSE(shows("##file browser"));
  run("file.export");
  headless_.key(Key::enter);
  EXPECT_TRUE(shows("##file browser"));
}

TEST_F(DialogFocus, SpaceTicksABoxAndOpensAListThatArrowsWalk) {
  open_bar();
  run("file.export");
  tab_to("Transparent background");
  const Image before = headless_.picture();
  headless_.key(Key::space);
  EXPECT_GT(differing_pixels(before, headless_.picture()), 20);
  headless_.key(Key::space);
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
  headless_.key(Key::escape);
  search_and_run("edit: keys");
  tab_to("Foldless");
  headless_.key(Key::space);
  headless_.key(Key::down);
  headless_.key(Key::enter);
  EXPECT_EQ(editor().keys().choice().preset, "photoshop");
  EXPECT_TRUE(shows("##keys"));
}

TEST_F(DialogFocus, TheRingIsSeenUntilTheMouseIsPressed) {
  open_bar();
  headless_.click(headless_.window_point({0, 0.5}));
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  headless_.key(Key::q, kControl);
  headless_.calm_down();
  const Image before = headless_.picture();
  tab();
  EXPECT_GT(differing_pixels(before, headless_.picture()), 100);
  headless_.press({4, 400});
  headless_.release({4, 400});
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
}

TEST_F(DialogFocus, WithoutADialogTabShowsTheMesh) {
  open_bar();
  const bool before = editor().view().is_mesh_shown();
  headless_.key(Key::tab);
  EXPECT_NE(editor().view().is_mesh_shown(), before);
}

}  // namespace
}  // namespace foldless::test
