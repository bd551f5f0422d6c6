// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program but its window, driven by mouse and keys: state and pixels at each stage.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class WholeEditor : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "foldless-ui-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    const Shape shape = bar(4, 1, 5);
    write_mesh(folder_ / "bar.obj", shape.triangles, shape.rest);
    headless_.editor().files().open(folder_ / "bar.obj");
    headless_.calm_down();
    ASSERT_FALSE(headless_.editor().document().is_empty());
    left_ = nearest_vertex({0, 0.5});
    right_ = nearest_vertex({4, 0.5});
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Editor& editor() { return headless_.editor(); }
  int nearest_vertex(const Vec2& point) {
    Eigen::Index nearest = 0;
    (editor().shown()->deformed.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  }
  void click_vertex(int vertex) {
    headless_.click(headless_.window_point(headless_.position(vertex)));
  }
  bool is_valid() {
    const Snapshot& shown = *editor().shown();
    return is_injective(*shown.triangles, *shown.rest) &&
           is_injective(*shown.triangles, shown.deformed);
  }
  /// Selection is no part of the document: a scene opens without one.
  void deselect() {
    headless_.key(Key::a, kControlShift);
    headless_.calm_down();
  }
  void place_two_handles() {
    click_vertex(left_);
    click_vertex(right_);
    ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
    deselect();
  }
  /// Drags the right handle by (dx, dy) window coordinates and waits for the solver.
  void drag_right_handle(const Vec2& by) {
    const Vec2 from = headless_.window_point(headless_.position(right_));
    headless_.press(from);
    headless_.move(from + by / 2);
    headless_.move(from + by);
    headless_.release(from + by);
    ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
    deselect();
  }
  void save_by_keyboard(const std::filesystem::path& path) {
    headless_.key(Key::s, kControl);
    headless_.key(Key::a, kControl);
    headless_.type(path.string());
    headless_.key(Key::enter);
    headless_.calm_down();
  }

  std::filesystem::path folder_;
  HeadlessEditor headless_{{1000, 640}};
  int left_ = 0;
  int right_ = 0;
};

TEST_F(WholeEditor, PlacesDragsConvergesUndoesRedoesSavesAndReloads) {
  const Image empty = headless_.canvas_picture();

  place_two_handles();
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  ASSERT_EQ(editor().document().handles.size(), 2U);
  const Image placed = headless_.canvas_picture();
  EXPECT_GT(differing_pixels(empty, placed), 50) << "two handles should be seen";
  EXPECT_LT(differing_pixels(empty, placed), 5000) << "and nothing else should change";
  const Points before = editor().shown()->deformed;

  const Vec2 target = editor().canvas().to_world(
      editor().canvas().to_pixel(headless_.position(right_)) + Vec2(-60, -150));
  drag_right_handle({-60, -150});
  EXPECT_EQ(editor().status().kind, StatusKind::converged) << editor().status().words;
  EXPECT_LT((headless_.position(right_) - target).norm(), 1e-4);
  EXPECT_EQ(editor().draft().proof().inverted, 0);
  EXPECT_TRUE(is_valid());
  const Points bent = editor().shown()->deformed;
  const Image bent_picture = headless_.canvas_picture();
  EXPECT_GT(differing_pixels(placed, bent_picture), 5000) << "the mesh should have moved";

  headless_.play(R"({"held": ["ctrl"]}
{"key": "Z", "held": ["ctrl"]}
{"key_up": "Z"}
{"held": []})");
  headless_.calm_down();
  EXPECT_EQ(editor().shown()->deformed, before);
  EXPECT_EQ(differing_pixels(headless_.canvas_picture(), placed), 0);

  headless_.play(R"({"held": ["shift", "ctrl"]}
{"key": "Z", "held": ["shift", "ctrl"]}
{"key_up": "Z"}
{"held": []})");
  headless_.calm_down();
  EXPECT_EQ(editor().shown()->deformed, bent);
  EXPECT_EQ(differing_pixels(headless_.canvas_picture(), bent_picture), 0);

  const auto file = folder_ / "bent.json";
  EXPECT_TRUE(editor().files().is_dirty());
  save_by_keyboard(file);
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(editor().files().is_dirty());

  headless_.key(Key::n, kControl);
  headless_.calm_down();
  EXPECT_TRUE(editor().document().is_empty());
  headless_.key(Key::o, kControl);
  headless_.type(file.string());
  headless_.key(Key::enter);
  headless_.calm_down();
  ASSERT_FALSE(editor().document().is_empty());
  EXPECT_EQ(editor().document().handles.size(), 2U);
  EXPECT_EQ(editor().shown()->deformed, bent);
  EXPECT_EQ(differing_pixels(headless_.canvas_picture(), bent_picture), 0);
}

TEST_F(WholeEditor, UnderFoldlessAHandleStaysUnderThePointerWhileItIsDragged) {
  place_two_handles();
  editor().edits().set_method("foldless");
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  Vec2 pointer = headless_.window_point(headless_.position(right_));
  headless_.press(pointer);
  for (int k = 0; k < 12; ++k) {
    pointer += k < 8 ? Vec2(-6, -12) : Vec2(9, 8);
    headless_.move(pointer);
    EXPECT_TRUE(headless_.wait_until(
        [&] { return (headless_.window_point(headless_.position(right_)) - pointer).norm() < 0.1; },
        10))
        << "move " << k;
    ASSERT_TRUE(is_valid()) << "move " << k;
  }
  EXPECT_TRUE(editor().draft().is_editing()) << "the button is still down";
  EXPECT_TRUE(std::ranges::any_of(editor().playback().iterations(), [](const Iteration& iteration) {
    return iteration.phase == Phase::pursue;
  }));
  headless_.release(pointer);
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  EXPECT_EQ(editor().status().kind, StatusKind::converged) << editor().status().words;
}

TEST_F(WholeEditor, ShowsTheGhostWhileDraggingAndEscapeTakesTheDragBack) {
  place_two_handles();
  const Points before = editor().shown()->deformed;
  const Vec2 from = headless_.window_point(headless_.position(right_));
  headless_.press(from);
  headless_.move(from + Vec2(0, -40));
  headless_.move(from + Vec2(0, -120));
  EXPECT_TRUE(editor().draft().is_editing());
  headless_.key(Key::escape);
  EXPECT_FALSE(editor().draft().is_editing());
  headless_.release(from + Vec2(0, -120));
  headless_.calm_down();
  EXPECT_EQ(editor().shown()->deformed, before);
  EXPECT_EQ(editor().document().handles.size(), 2U);
}

TEST_F(WholeEditor, ClicksOnPanelsDoNotReachTheCanvas) {
  const Layout& layout = headless_.ui().layout();
  headless_.click({layout.right.x + 100, layout.right.y + layout.right.height - 20});
  headless_.click({layout.menu_bar.width - 40, 10});
  EXPECT_TRUE(editor().document().handles.empty());
}

TEST_F(WholeEditor, AsksBeforeUnsavedChangesAreLost) {
  place_two_handles();
  const auto shots = headless_.play(R"({"shot": "before"}
{"held": ["ctrl"]}
{"key": "Q", "held": ["ctrl"]}
{"key_up": "Q"}
{"held": []}
{"shot": "asked"})");
  EXPECT_GT(differing_pixels(shots.at("before"), shots.at("asked")), 10000);
  EXPECT_FALSE(headless_.ui().wants_to_quit());
  ASSERT_NE(editor().files().question(), nullptr);
  headless_.play(R"({"key": "Esc"}
{"key_up": "Esc"})");
  EXPECT_EQ(editor().files().question(), nullptr);
  EXPECT_FALSE(headless_.ui().wants_to_quit());
  EXPECT_EQ(editor().document().handles.size(), 2U);
}

TEST_F(WholeEditor, ShowsTheQuestionThoughNoEventFollowsTheCloseButton) {
  place_two_handles();
  const Image before = headless_.picture();
  editor().files().close();
  headless_.settle();
  EXPECT_GT(differing_pixels(before, headless_.picture()), 10000);
}

TEST_F(WholeEditor, WritesNumberedPicturesOfTheCanvas) {
  place_two_handles();
  save_by_keyboard(folder_ / "shot.json");
  headless_.play(R"({"key": "F12"}
{"key_up": "F12"}
{"t": 1, "key": "F12"}
{"t": 1.1, "key_up": "F12"})");
  const Image picture = load_image(folder_ / "shot-0002.png");
  EXPECT_EQ(picture.width, editor().canvas().width);
  EXPECT_EQ(picture.height, editor().canvas().height);
  EXPECT_EQ(read_png_texts(folder_ / "shot-0001.png").at("Scene"),
            (folder_ / "shot.json").string());
}

TEST_F(WholeEditor, FindsAndRunsACommandByItsLetters) {
  headless_.play(R"({"held": ["ctrl"]}
{"key": "K", "held": ["ctrl"]}
{"key_up": "K"}
{"held": []}
{"type": "heat map"})");
  EXPECT_FALSE(editor().view().options().layers.heat) << "typing must not switch layers";
  headless_.play(R"({"key": "Enter"}
{"key_up": "Enter"})");
  EXPECT_TRUE(editor().view().options().layers.heat);
}

TEST_F(WholeEditor, HitsTheSamePlacesAtTwiceTheScale) {
  headless_.set_content_scale(2);
  headless_.settle();
  editor().view().fit_all();
  place_two_handles();
  ASSERT_EQ(editor().document().handles.size(), 2U);
  EXPECT_EQ(editor().document().handles[0].vertex, left_);
  EXPECT_EQ(editor().document().handles[1].vertex, right_);
}

}  // namespace
}  // namespace foldless::test
