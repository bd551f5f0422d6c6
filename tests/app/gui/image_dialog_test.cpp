// SPDX-License-Identifier: GPL-3.0-or-later
// From a picture to a pose, by mouse and keys: state and pixels.
#include <gtest/gtest.h>

#include "tests/app/gui/headless_editor.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class ImageDialog : public testing::Test {
 protected:
  ImageDialog() { write_ring(ring(), 300); }

  std::filesystem::path ring() const { return folder_.path() / "ring.png"; }
  Editor& editor() { return headless_.editor(); }
  void open() {
    editor().files().open(ring());
    ASSERT_TRUE(
        headless_.wait_until([this] { return editor().files().image_import().is_ready(); }));
  }
  /// The pixel of the window over a point of the mesh's plane.
  const std::uint8_t* pixel(const Image& picture, const Vec2& world) {
    const Vec2 at = headless_.window_point(world);
    return picture.at(static_cast<int>(at.x()), static_cast<int>(at.y()));
  }

  TemporaryFolder folder_;
  HeadlessEditor headless_{{1000, 640}};
};

TEST_F(ImageDialog, ShowsTheMeshBeforeItIsTaken) {
  const Image before = headless_.canvas_picture();
  open();
  EXPECT_GT(differing_pixels(before, headless_.canvas_picture()), 20000);
  EXPECT_TRUE(editor().document().is_empty());
}

TEST_F(ImageDialog, WhatWasADrawingIsExportedWithItsTransparency) {
  open();
  headless_.key(Key::enter);
  headless_.calm_down();
  headless_.key(Key::e, {.control = true});
  headless_.key(Key::enter);
  headless_.calm_down();
  headless_.key(Key::a, {.control = true});
  headless_.type((folder_.path() / "out.png").string());
  headless_.key(Key::enter);
  headless_.calm_down();
  const Image written = load_image(folder_.path() / "out.png");
  EXPECT_EQ(written.at(0, 0)[3], 0);
  EXPECT_EQ(written.width, headless_.canvas_picture().width);
}

TEST_F(ImageDialog, EnterShowsThePictureAloneAndTabTheMesh) {
  open();
  headless_.key(Key::enter);
  ASSERT_FALSE(editor().document().is_empty());
  headless_.calm_down();
  // On the ring, in its hole and on the disk: the picture's own colours, or the canvas.
  const Image alone = headless_.picture();
  const Image source = load_image(ring());
  for (const Vec2& p : {Vec2(244, 152), Vec2(148, 240), Vec2(60, 152), Vec2(148, 152)}) {
    const std::uint8_t* drawn = pixel(alone, p);
    const std::uint8_t* original =
        source.at(static_cast<int>(p.x()), static_cast<int>(300 - p.y()));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], original[c], 6) << p.transpose() << ' ' << c;
  }
  headless_.key(Key::tab);
  headless_.calm_down();
  const Image with_mesh = headless_.picture();
  EXPECT_GT(differing_pixels(alone, with_mesh), 5000);
  headless_.key(Key::tab);
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(alone, headless_.picture()), 0);
}

TEST_F(ImageDialog, ComesUpForAPictureThatIsChosenInTheFileBrowser) {
  headless_.key(Key::o, {.control = true});
  headless_.type(ring().string());
  headless_.key(Key::enter);
  ASSERT_TRUE(headless_.wait_until([this] { return editor().files().image_import().is_ready(); }));
  EXPECT_TRUE(editor().document().is_empty()) << "the Enter that chose it must not take it";
  headless_.key(Key::enter);
  EXPECT_EQ(editor().document().name, "ring");
}

TEST_F(ImageDialog, EscapeLeavesTheScreenAsItWas) {
  // Until the samples have their pictures.
  ASSERT_TRUE(headless_.wait_until([this] { return !headless_.next_frame(); }));
  const Image before = headless_.picture();
  open();
  headless_.key(Key::escape);
  headless_.calm_down();
  EXPECT_FALSE(editor().files().image_import().is_open());
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
}

TEST_F(ImageDialog, TheMouseDoesNotReachTheDocumentBehindIt) {
  open();
  headless_.key(Key::enter);
  headless_.calm_down();
  open();
  headless_.click(headless_.window_point({240, 150}));
  headless_.key(Key::tab);
  EXPECT_TRUE(editor().document().handles.empty());
  EXPECT_FALSE(editor().view().is_mesh_shown());
}

TEST_F(ImageDialog, ADraggedPinTakesThePictureWithIt) {
  open();
  headless_.key(Key::enter);
  headless_.calm_down();
  headless_.click(headless_.window_point({60, 150}));
  const Vec2 from = headless_.window_point({240, 150});
  headless_.press(from);
  for (int k = 1; k <= 5; ++k) headless_.move(from + k * Vec2(12, 0));
  headless_.release(from + Vec2(60, 0));
  ASSERT_TRUE(headless_.wait_until([this] { return !editor().playback().is_solving(); }));
  headless_.calm_down();
  EXPECT_EQ(editor().draft().proof().inverted, 0);
  const Vec2 target = find_handle(editor().document(), 1)->target;
  EXPECT_GT(target.x(), 260);
  editor().view().options().layers.handles = false;
  headless_.calm_down();
  const Image picture = headless_.picture();
  const std::uint8_t* drawn = pixel(picture, target);
  EXPECT_NEAR(drawn[0], 255 * 240 / 300, 8) << "the colour of where the pin was";
}

TEST_F(ImageDialog, AnImageOfTwentyFourMegapixelsDoesNotHoldUpTheWindow) {
  save_png(folder_.path() / "large.png", painted(opaque_map(6000, 4000)));
  editor().files().open(folder_.path() / "large.png");
  int frames = 0;
  const bool ready = headless_.wait_until([&] {
    ++frames;
    return editor().files().image_import().is_ready();
  });
  EXPECT_TRUE(ready);
  EXPECT_GT(frames, 5) << "the window goes on while the image is read";
}

}  // namespace
}  // namespace foldless::test
