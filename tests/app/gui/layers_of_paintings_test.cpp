// SPDX-License-Identifier: GPL-3.0-or-later
// A painting of several layers in the whole editor: state and pixels.
#include <gtest/gtest.h>

#include "tests/app/gui/headless_editor.h"
#include "tests/support/layered_files.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class LayersOfPaintings : public testing::Test {
 protected:
  LayersOfPaintings() : file_(folder_.write("doll.ora", ora_of(doll()))) {}

  Editor& editor() { return headless_.editor(); }
  ImageImport& import() { return editor().files().image_import(); }
  void open() {
    editor().files().open(file_);
    ASSERT_TRUE(headless_.wait_until([this] { return import().is_ready(); }));
  }
  void take() {
    open();
    headless_.key(Key::enter);
    headless_.calm_down();
    ASSERT_NE(editor().document().parts, nullptr);
  }
  /// The pixel of a picture over a point of the plane.
  const std::uint8_t* pixel(const Image& picture, const Vec2& world) {
    const Vec2 at = headless_.window_point(world);
    return picture.at(static_cast<int>(at.x()), static_cast<int>(at.y()));
  }
  /// Presses on a point of the mesh and drags it.
  void drag(const Vec2& from, const Vec2& to) {
    headless_.press(headless_.window_point(from));
    for (int k = 1; k <= 4; ++k) headless_.move(headless_.window_point(from + (to - from) * k / 4));
    headless_.release(headless_.window_point(to));
    ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  }

  TemporaryFolder folder_;
  std::filesystem::path file_;
  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(LayersOfPaintings, ShowThePaintingAsItIs) {
  take();
  const Image picture = headless_.picture();
  const Image painting = doll().merged;
  // Body, arm over body, arm, other arm.
  for (const Vec2& p : {Vec2(84, 36), Vec2(60, 108), Vec2(20, 108), Vec2(140, 108)}) {
    const std::uint8_t* original =
        painting.at(static_cast<int>(p.x()), 200 - static_cast<int>(p.y()));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(pixel(picture, p)[c], original[c], 8) << p.transpose() << ' ' << c;
  }
}

TEST_F(LayersOfPaintings, APartIsDraggedByItselfOverTheOthers) {
  take();
  // The left arm is held at its shoulder and its hand is drawn over the body.
  headless_.click(headless_.window_point({58, 108}));
  drag({16, 108}, {60, 60});
  headless_.calm_down();
  const Document& document = editor().document();
  const MeshPart& arm = document.parts->at(2);
  ASSERT_EQ(document.handles.size(), 2U);
  for (Eigen::Index v = 0; v < document.original->rest.cols(); ++v) {
    const bool is_of_arm = v >= arm.first_vertex && v < arm.first_vertex + arm.vertices;
    ASSERT_TRUE(is_of_arm || document.pose->deformed.col(v) == document.pose->rest->col(v))
        << "others stay";
  }
  const Image picture = headless_.picture();
  // Arms are blue or green, the body red.
  EXPECT_EQ(pixel(picture, {59, 84})[2], 240) << "between its handles";
  EXPECT_EQ(pixel(picture, {80, 20})[0], 240);
}

TEST_F(LayersOfPaintings, ChooseOnePictureInTheDialog) {
  open();
  const Image by_layer = headless_.picture();
  headless_.click({870, 125});  // the second of the two at the top of the dialog
  EXPECT_FALSE(import().is_by_layer());
  ASSERT_TRUE(headless_.wait_until([this] { return import().is_ready(); }));
  EXPECT_GT(differing_pixels(by_layer, headless_.picture()), 500);
  headless_.key(Key::enter);
  headless_.calm_down();
  EXPECT_EQ(editor().document().parts, nullptr);
}

}  // namespace
}  // namespace foldless::test
