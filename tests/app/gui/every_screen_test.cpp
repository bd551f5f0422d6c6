// SPDX-License-Identifier: GPL-3.0-or-later
// HeadlessEditor fails a test where anything that was drawn is cut or lies over other words. Here
// it sees every screen, in every theme, at both sizes; and what it is there to find.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <array>
#include <string>
#include <tuple>

#include "app/editor/edits.h"
#include "app/gui/samples.h"
#include "app/gui/zoom_menu.h"
#include "core/data_path.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/drawing_defects.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class DrawingDefects : public testing::Test {
 protected:
  template <class Draw>
  std::vector<std::string> defects_of(Draw draw) {
    headless_.calm_down();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({20, 20});
    ImGui::SetNextWindowSize({300, 200});
    ImGui::Begin("##tested", nullptr, ImGuiWindowFlags_NoDecoration);
    draw(*ImGui::GetWindowDrawList());
    ImGui::End();
    ImGui::Render();
    return drawing_defects();
  }

  HeadlessEditor headless_;
};

TEST_F(DrawingDefects, AreNoneWhereAllHasRoom) {
  EXPECT_TRUE(defects_of([](ImDrawList& list) {
                ImGui::TextUnformatted("one");
                ImGui::Button("two");
                list.AddRectFilled({40, 100}, {80, 120}, IM_COL32_WHITE, 4);
              }).empty());
}

TEST_F(DrawingDefects, ATextIsCutAtAnyEdge) {
  for (const ImVec2 at : {ImVec2{300, 60}, ImVec2{10, 60}, ImVec2{100, 10}, ImVec2{100, 210}}) {
    const auto defects = defects_of(
        [&](ImDrawList& list) { list.AddText(at, IM_COL32_WHITE, "too wide or too high"); });
    ASSERT_FALSE(defects.empty()) << at.x << ", " << at.y;
    EXPECT_NE(defects.front().find("is cut"), std::string::npos) << defects.front();
  }
}

TEST_F(DrawingDefects, ATextIsCutInItsOwnRoom) {
  EXPECT_FALSE(defects_of([](ImDrawList& list) {
                 const ImVec4 room{40, 60, 75, 90};
                 list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {40, 60}, IM_COL32_WHITE,
                              "Remeshing-assisted", nullptr, 0, &room);
               }).empty());
}

TEST_F(DrawingDefects, AShapeIsCut) {
  EXPECT_FALSE(defects_of([](ImDrawList& list) {
                 list.AddCircleFilled({318, 60}, 6, IM_COL32_WHITE);
               }).empty());
}

TEST_F(DrawingDefects, TextsLieOverEachOther) {
  const auto defects = defects_of([](ImDrawList& list) {
    list.AddText({40, 60}, IM_COL32_WHITE, "below");
    list.AddText({55, 64}, IM_COL32(255, 0, 0, 255), "above");
  });
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_NE(defects.front().find("\"below\" lies over \"above\""), std::string::npos)
      << defects.front();
}

/// Size of the interface and theme.
class EveryScreen : public testing::TestWithParam<std::tuple<float, Theme>> {
 protected:
  EveryScreen() : headless_(size()) {
    headless_.set_content_scale(std::get<0>(GetParam()));
    headless_.ui().settings().theme = std::get<1>(GetParam());
    headless_.settle();
  }
  static Extent size() {
    return std::get<0>(GetParam()) > 1 ? Extent{1600, 1000} : Extent{1100, 700};
  }
  void run(std::string_view command) {
    headless_.editor().run_command(command);
    headless_.settle();
  }
  void look_at(std::string_view dialog) {
    SCOPED_TRACE(std::string(dialog));
    run(dialog);
    headless_.key(Key::escape);
    headless_.settle();
  }
  /// Also while a key is asked for that another command has.
  void open_keys() {
    headless_.key(Key::k, kControl);
    headless_.type("edit: keys");
    headless_.key(Key::enter);
    headless_.click(headless_.find_words("Ctrl+N").value());
    headless_.key(Key::o, kControl);
    for (int i = 0; i < 2; ++i) headless_.key(Key::escape);
  }
  void wait_for_the_solver() {
    ASSERT_TRUE(
        headless_.wait_until([this] { return !headless_.editor().playback().is_solving(); }));
    headless_.calm_down();
  }

  HeadlessEditor headless_;
};

TEST_P(EveryScreen, BeforeAnythingIsOpen) {
  headless_.calm_down();
  for (const char* dialog : {"file.open", "help.keys"}) look_at(dialog);
}

TEST_P(EveryScreen, OfADocument) {
  headless_.editor().files().open_sample(find_samples().front().path);
  wait_for_the_solver();
  for (const Workspace workspace : {Workspace::animate, Workspace::lab}) {
    headless_.ui().settings().workspace = workspace;
    run("select.all");
    wait_for_the_solver();
    run("select.none");
    run("motion.toggle");  // without keys
    headless_.calm_down();
    run("motion.toggle");
    for (const char* dialog :
         {"file.save_as", "file.export", "file.texture", "help.search", "help.keys"})
      look_at(dialog);
    open_keys();
    run("view.remesh_diff");
    headless_.calm_down();
    run("compare.side_by_side");  // in place of the rest mesh
    headless_.calm_down();
    run("compare.side_by_side");
    run("stiffness.paint");
    headless_.calm_down();
    run("stiffness.paint");
  }
}

TEST_P(EveryScreen, OfARace) {
  headless_.editor().files().open_shape(bar(4, 1, 3), "bar");
  Document document = headless_.editor().document();
  for (const int vertex : {0, 12}) document = place_handle(document, {.vertex = vertex}).document;
  document = with_targets(document, {{1, Vec2(2, 2.5)}});
  headless_.editor().draft().begin_edit();
  headless_.editor().draft().apply(document, Change::mesh);
  headless_.editor().draft().commit("Bend");
  wait_for_the_solver();
  run("race.toggle");
  ASSERT_TRUE(headless_.wait_until([this] { return headless_.editor().race().is_finished(); }));
  headless_.calm_down();
}

TEST_P(EveryScreen, OfATimeLine) {
  headless_.editor().files().open_sample(data_path("assets/scenes/walk.json"));
  ASSERT_TRUE(headless_.wait_until(
      [this] { return headless_.editor().status().kind == StatusKind::converged; }));
  for (const Workspace workspace : {Workspace::animate, Workspace::lab}) {
    headless_.ui().settings().workspace = workspace;
    run("motion.select_keys");
    run("motion.onion_skin");
    headless_.editor().motion().play_head().go_to(workspace == Workspace::lab ? 23 : 11);
    headless_.calm_down();
    look_at("file.export");
  }
  run("file.export");
  headless_.click(headless_.find_words("Animated WebP (.webp)").value());
  headless_.click(headless_.find_words("glTF, baked (.glb)").value());
  headless_.settle();
}

TEST_P(EveryScreen, OfAPicture) {
  const TemporaryFolder folder;
  write_ring(folder / "ring.png", 256);
  headless_.editor().files().open(folder / "ring.png");
  ASSERT_TRUE(headless_.wait_until(
      [this] { return headless_.editor().files().image_import().is_ready(); }));
  headless_.calm_down();
  headless_.key(Key::enter);
  headless_.ui().settings().shows_rulers = true;
  headless_.calm_down();
  headless_.click(headless_.find_words(zoom_words(headless_.editor())).value());
  headless_.key(Key::escape);
}

TEST_P(EveryScreen, OfMenus) {
  headless_.editor().files().open_shape(bar(4, 1, 3), "bar");
  headless_.calm_down();
  headless_.click({25, 14});
  for (const double x : {66, 122, 182, 234, 282}) {
    headless_.move({x, 14});  // one opens in place of the other
    EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(SizesAndThemes, EveryScreen,
                         testing::Combine(testing::Values(1.0F, 2.0F),
                                          testing::Values(Theme::dark, Theme::light,
                                                          Theme::contrast)));

}  // namespace
}  // namespace foldless::test
