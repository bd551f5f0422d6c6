// SPDX-License-Identifier: GPL-3.0-or-later
// What helps to measure a drawing: the outline of its canvas, rulers, and the menu of zoom levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "app/gui/settings.h"
#include "app/gui/zoom_menu.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// A drawing of 300 × 300 pixels; the settings are kept in a folder.
class Artboard : public testing::TestWithParam<float> {
 protected:
  Artboard() {
    write_ring(folder_ / "ring.png", 300);
    start();
    editor().files().open(folder_ / "ring.png");
    EXPECT_TRUE(
        headless_->wait_until([this] { return editor().files().image_import().is_ready(); }));
    headless_->key(Key::enter);
    headless_->calm_down();
  }
  void start() {
    headless_.reset();
    const auto side = [](int length) { return static_cast<int>(length * GetParam()); };
    headless_.emplace(Extent{side(1000), side(640)}, UiOptions{.state_folder = folder_.path()});
    headless_->set_content_scale(GetParam());
    headless_->settle();
  }
  Editor& editor() { return headless_->editor(); }
  const Layout& layout() { return headless_->ui().layout(); }
  void search_and_run(std::string_view words) {
    headless_->key(Key::k, kControl);
    headless_->type(words);
    headless_->key(Key::enter);
    headless_->calm_down();
  }
  /// In framebuffer pixels of the window.
  Vec2 pixel_of(const Vec2& world) { return headless_->window_point(world) * GetParam(); }
  static bool is_same(const std::uint8_t* a, const std::uint8_t* b) {
    return std::equal(a, a + 3, b);
  }
  /// The button in the status bar.
  void open_zoom_menu(const std::string& words) {
    headless_->click(headless_->find_words(words).value());
  }
  double percent() { return 100 * editor().view().zoom_level(); }

  TemporaryFolder folder_;
  std::optional<HeadlessEditor> headless_;
};

TEST_P(Artboard, IsOutlinedUntilItIsSwitchedOff) {
  editor().run_command("view.fit_canvas");
  headless_->calm_down();
  const Image with = headless_->picture();
  const Vec2 low = pixel_of({0, 0}), high = pixel_of({300, 300});
  ASSERT_TRUE(layout().canvas.contains(low.x(), high.y()));
  ASSERT_TRUE(layout().canvas.contains(high.x(), low.y())) << "the whole of it is seen";
  search_and_run("outline of the canvas");
  const Image without = headless_->picture();
  const auto differs = [&](const Vec2& at) {  // a line is thinner than rounding is exact
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) {
        const int px = static_cast<int>(at.x()) + x, py = static_cast<int>(at.y()) + y;
        if (!is_same(with.at(px, py), without.at(px, py))) return true;
      }
    return false;
  };
  for (const Vec2& on : {Vec2(150, 0), Vec2(150, 300), Vec2(0, 150), Vec2(300, 150)})
    EXPECT_TRUE(differs(pixel_of(on))) << on.transpose();
  EXPECT_FALSE(differs(pixel_of({20, 20})));
  start();
  EXPECT_FALSE(headless_->ui().settings().shows_artboard) << "it is remembered";
}

TEST_P(Artboard, SquaresShowWhereItIsTransparentAndAreNeverExported) {
  editor().run_command("view.fit_canvas");
  const auto exported = [&](const char* name) {
    headless_->key(Key::e, kControl);
    headless_->key(Key::enter);
    headless_->key(Key::a, kControl);
    headless_->type((folder_ / name).string());
    headless_->key(Key::enter);
    headless_->calm_down();
    return load_image(folder_ / name);
  };
  headless_->calm_down();
  const Image plain_export = exported("plain.png"), plain = headless_->picture();
  search_and_run("squares behind");
  const Image with = headless_->picture();
  const auto at = [&](const Image& image, const Vec2& world) {
    const Vec2 pixel = pixel_of(world);
    return image.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  };
  const Vec2 in_a_corner(8, 8), on_the_ring(244, 152), beside(-8, 150);
  EXPECT_FALSE(is_same(at(plain, in_a_corner), at(with, in_a_corner)));
  EXPECT_TRUE(is_same(at(plain, on_the_ring), at(with, on_the_ring)));
  EXPECT_TRUE(is_same(at(plain, beside), at(with, beside)));
  EXPECT_EQ(exported("squares.png"), plain_export);
  start();
  EXPECT_TRUE(headless_->ui().settings().shows_squares) << "it is remembered";
}

TEST_P(Artboard, RulersMarkRoundCoordinatesAndThePointer) {
  EXPECT_EQ(layout().rulers.top.width, 0);
  headless_->key(Key::r, {.shift = true});
  editor().run_command("view.actual_size");  // a number every hundred pixels
  headless_->calm_down();
  const Rectangle top = layout().rulers.top, left = layout().rulers.left;
  ASSERT_GT(top.width, 0);
  EXPECT_EQ(layout().canvas.y, top.y + top.height);
  EXPECT_EQ(layout().canvas.x, left.x + left.width);
  const Image picture = headless_->picture();
  const auto at = [&](double x, double y) {
    return picture.at(static_cast<int>(x), static_cast<int>(y));
  };
  const auto has_tick_near = [&](double x, double y, const Vec2& along, const Vec2& beside) {
    for (int d = -1; d <= 1; ++d)
      if (!is_same(at(x + d * along.x(), y + d * along.y()), at(x + beside.x(), y + beside.y())))
        return true;
    return false;
  };
  const double inside = GetParam();  // beyond the numbers and the short ticks
  const double aside = 4 * GetParam();
  for (const double value : {100.0, 200.0}) {
    const Vec2 on = pixel_of({value, value});
    EXPECT_TRUE(has_tick_near(on.x(), top.y + inside, {1, 0}, {-aside, 0})) << value;
    EXPECT_TRUE(has_tick_near(left.x + inside, on.y(), {0, 1}, {0, aside})) << value;
    const Vec2 off = pixel_of({value + 33, value + 33});
    EXPECT_FALSE(has_tick_near(off.x(), top.y + inside, {1, 0}, {-aside, 0})) << value;
  }
  headless_->move(headless_->window_point({133, 133}));
  const Image marked = headless_->picture();
  const Vec2 pointer = pixel_of({133, 133});
  const auto column = static_cast<int>(pointer.x()), row = static_cast<int>(top.y + inside);
  EXPECT_FALSE(is_same(marked.at(column, row), picture.at(column, row)));
  start();
  EXPECT_TRUE(headless_->ui().settings().shows_rulers) << "they are remembered";
}

TEST_P(Artboard, HasNoRulersOverARaceOrTheStartScreen) {
  headless_->key(Key::r, {.shift = true});
  ASSERT_GT(layout().rulers.top.width, 0);
  headless_->click(headless_->window_point(editor().shown()->deformed.col(0)));
  headless_->key(Key::m);
  ASSERT_TRUE(editor().race().is_open());
  EXPECT_EQ(layout().rulers.top.width, 0);
  headless_->key(Key::escape);
  EXPECT_GT(layout().rulers.top.width, 0);
  headless_->key(Key::backslash, kControl);
  EXPECT_GT(layout().side_rulers.top.width, 0) << "both panes have some";
  EXPECT_EQ(layout().side.width, layout().canvas.width);
  start();
  EXPECT_EQ(layout().rulers.top.width, 0) << "nothing is open";
}

TEST_P(Artboard, ZoomLevelsAreChosenInAMenuOrTyped) {
  editor().run_command("view.actual_size");
  headless_->calm_down();
  open_zoom_menu("100 %");
  headless_->click(headless_->find_words("200 %").value());
  EXPECT_DOUBLE_EQ(percent(), 200);
  EXPECT_DOUBLE_EQ(editor().canvas().camera.pixels_per_unit, 2 * GetParam());
  open_zoom_menu("200 %");
  headless_->type("62.5");
  headless_->key(Key::enter);
  EXPECT_DOUBLE_EQ(percent(), 62.5);
  open_zoom_menu("62.5 %");
  headless_->type("-5");
  headless_->key(Key::enter);
  EXPECT_DOUBLE_EQ(percent(), 62.5) << "no magnification";
  open_zoom_menu("62.5 %");
  headless_->click(headless_->find_words("Fit all").value());
  const Camera chosen = editor().canvas().camera;
  editor().view().fit_all();
  EXPECT_EQ(editor().canvas().camera, chosen);
  open_zoom_menu(zoom_words(editor()));
  headless_->key(Key::escape);
  EXPECT_FALSE(headless_->find_words("Fit all")) << "Esc closes the menu";
}

INSTANTIATE_TEST_SUITE_P(Scales, Artboard, testing::Values(1.0F, 2.0F));

}  // namespace
}  // namespace foldless::test
