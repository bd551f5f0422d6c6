// SPDX-License-Identifier: GPL-3.0-or-later
// Bones and the mirror on the canvas.
#include <gtest/gtest.h>

#include "app/gui/hints.h"
#include "core/files/atomic_file.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// Three handles along a strip, root at the left.
class CanvasBones : public testing::Test {
 protected:
  CanvasBones() {
    headless_.editor().files().open_shape(grid({.columns = 12, .rows = 4, .width = 6}), "strip");
    headless_.calm_down();
    middle_ = headless_.editor().shown()->deformed.rowwise().mean();
    for (const double x : {-2.0, 0.0, 2.0}) headless_.click(window_point(x));
    headless_.calm_down();
  }
  Vec2 window_point(double x) const { return headless_.window_point(middle_ + Vec2(x, 0)); }
  void make_bones() {
    for (const Handle& handle : headless_.editor().document().handles) {
      std::set<int> ids = headless_.editor().selection().ids();
      if (handle.id == 0) ids.clear();
      ids.insert(handle.id);
      headless_.editor().selection().select(ids);
    }
    headless_.key(Key::j);
    headless_.calm_down();
  }

  Vec2 middle_;
  HeadlessEditor headless_;
};

TEST_F(CanvasBones, AreDrawnAndHiddenWithTheHandles) {
  headless_.editor().selection().select({2});
  headless_.settle();
  const Image before = headless_.picture();
  make_bones();
  ASSERT_EQ(headless_.editor().document().rig.bones.size(), 1U);
  EXPECT_GT(differing_pixels(before, headless_.picture()), 1000);
  headless_.key(Key::digit_5);
  headless_.settle();
  const Image without = headless_.picture();
  headless_.key(Key::j, {.shift = true});
  headless_.calm_down();
  const Vec2 on_bone = window_point(1);
  const auto x = static_cast<int>(on_bone.x()), y = static_cast<int>(on_bone.y());
  const Image apart = headless_.picture();
  EXPECT_TRUE(std::equal(without.at(x, y), without.at(x, y) + 3, apart.at(x, y)))
      << "hidden with the handles";
}

TEST_F(CanvasBones, AreDraggedByTheirEndWithTheMouse) {
  make_bones();
  headless_.press(window_point(2));
  for (const double y : {0.4, 0.8, 1.2})
    headless_.move(headless_.window_point(middle_ + Vec2(1.5, y)));
  headless_.release(headless_.window_point(middle_ + Vec2(1.5, 1.2)));
  headless_.calm_down();
  const std::vector<Handle>& handles = headless_.editor().document().handles;
  EXPECT_NEAR((handles[1].target - handles[0].target).norm(), 2, 1e-9);
  EXPECT_NEAR((handles[2].target - handles[1].target).norm(), 2, 1e-9);
  EXPECT_LT((handles[2].target - middle_ - Vec2(1.5, 1.2)).norm(), 0.05);
}

TEST_F(CanvasBones, AreDrawnClickByClickAndTheNextOneIsSeenBefore) {
  headless_.key(Key::n);
  const Vec2 up = headless_.window_point(middle_ + Vec2(0, 1.2));
  headless_.click(window_point(-2));
  headless_.move(up);
  const Image with_next = headless_.canvas_picture();
  headless_.key(Key::enter);
  EXPECT_GT(differing_pixels(with_next, headless_.canvas_picture()), 300);
  for (const double x : {-2.0, 0.0, 2.0}) headless_.click(window_point(x));
  headless_.key(Key::enter);
  headless_.key(Key::v);
  EXPECT_FALSE(headless_.editor().bone_tool().is_on());
  EXPECT_EQ(headless_.editor().document().rig.bones, std::vector<Bones>({{0, 1, 2}}));
}

TEST_F(CanvasBones, HintsSayHowTheToolGoesOn) {
  const auto hint = [this] { return hint_words(headless_.editor(), {}); };
  EXPECT_EQ(hint().find("root"), std::string::npos);
  headless_.key(Key::n);
  EXPECT_NE(hint().find("root of bones"), std::string::npos) << hint();
  headless_.click(window_point(-2));
  EXPECT_NE(hint().find("Enter or Esc"), std::string::npos) << hint();
  headless_.key(Key::v);
  headless_.key(Key::x);
  headless_.move({4, 400});
  EXPECT_NE(hint().find("Mirror"), std::string::npos) << hint();
}

TEST_F(CanvasBones, AndTheMirrorStayOutOfExportedPicturesAndFigures) {
  const TemporaryFolder folder;
  const auto written = [&](const char* format, const char* name) {
    headless_.key(Key::e, kControl);
    headless_.click(headless_.find_words(format).value());
    headless_.key(Key::enter);
    headless_.key(Key::a, kControl);
    headless_.type((folder / name).string());
    headless_.key(Key::enter);
    EXPECT_TRUE(headless_.wait_until([this] { return !headless_.ui().is_exporting(); }));
    headless_.calm_down();
    return read_file(folder / name);
  };
  const auto png_of = [&](const char* name) {
    written("PNG picture", name);
    return load_image(folder / name);
  };
  const Image png = png_of("without.png");
  const std::string svg = written("SVG figure", "without.svg");
  ASSERT_NE(svg.find("<svg"), std::string::npos);
  const Image screen = headless_.canvas_picture();
  make_bones();
  headless_.key(Key::x);
  headless_.calm_down();
  ASSERT_GT(differing_pixels(screen, headless_.canvas_picture()), 2000) << "they are on screen";
  EXPECT_EQ(differing_pixels(png, png_of("with.png")), 0);
  EXPECT_EQ(svg, written("SVG figure", "with.svg"));
}

}  // namespace
}  // namespace foldless::test
