// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/marker_layer.h"

#include <gtest/gtest.h>

#include "render/theme.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

using test::bare_view;
using test::Canvas;
using test::difference;

/// A square of 200 pixels in a canvas of 300, with a handle in the middle of the canvas.
class Markers : public testing::Test {
 protected:
  Markers() {
    test::Fixture fixture = test::square_grid(3);
    fixture.rest *= 100;
    snapshot_ = test::undeformed(fixture);
    canvas_.view.camera.centre = {100, 100};
    options_.layers.handles = true;
  }

  void add(HandleKind kind, const Vec2& target = {100, 100}, double weight = 1) {
    const int id = static_cast<int>(snapshot_.handles.size()) + 10;
    snapshot_.handles.push_back({id, 4, target, kind, weight});
  }

  Image draw() { return canvas_.draw(snapshot_, options_); }
  const CanvasColours& colours() const { return canvas_colours(options_.theme); }

  Canvas canvas_{300, 300, 1};
  Snapshot snapshot_;
  ViewOptions options_ = bare_view();
};

TEST_F(Markers, ADragHandleIsADisc) {
  add(HandleKind::drag);
  const Image image = draw();
  EXPECT_LE(difference(image.at(150, 150), colours().handle), 1);
  EXPECT_LE(difference(image.at(143, 150), colours().handle_rim), 30);
  EXPECT_GT(difference(image.at(155, 155), colours().handle_rim), 100);
}

TEST_F(Markers, APinIsASquare) {
  add(HandleKind::pin);
  const Image image = draw();
  EXPECT_LE(difference(image.at(150, 150), colours().handle), 1);
  EXPECT_LE(difference(image.at(155, 155), colours().handle_rim), 30);
}

TEST_F(Markers, ASoftHandleIsARingThatGrowsWithItsWeight) {
  int widest = 0;
  for (const double weight : {0.1, 1.0, 10.0}) {
    snapshot_.handles.clear();
    add(HandleKind::soft, {100, 100}, weight);
    const Image image = draw();
    EXPECT_EQ(difference(image.at(150, 150), colours().background), 0) << "the ring is filled";
    int reach = 0;
    for (int x = 150; x < 200; ++x)
      if (difference(image.at(x, 150), colours().background) > 120) reach = x - 150;
    EXPECT_GT(reach, widest) << weight;
    widest = reach;
  }
}

TEST_F(Markers, SelectedAndHoveredHandlesStandOut) {
  add(HandleKind::drag);
  const Image plain = draw();
  canvas_.view.selected = {10};
  const Image selected = draw();
  canvas_.view.selected.clear();
  canvas_.view.hovered = 10;
  const Image hovered = draw();
  EXPECT_LE(difference(selected.at(150 + 8, 150), colours().selected), 40);
  EXPECT_GT(difference(plain.at(150 + 8, 150), selected.at(150 + 8, 150)), 60);
  EXPECT_GT(difference(plain.at(150 + 9, 150), hovered.at(150 + 9, 150)), 30);
}

TEST_F(Markers, AMissedTargetHasARingAndALine) {
  add(HandleKind::drag, {200, 100});
  const Image image = draw();
  const auto red_at = [&](int x) {
    return image.at(x, 150)[0] > 150 && image.at(x, 150)[0] > 1.5 * image.at(x, 150)[1];
  };
  EXPECT_EQ(difference(image.at(250, 150), colours().background), 0) << "the ring is hollow";
  EXPECT_TRUE(red_at(250 + 6));
  int dashes = 0;
  for (int x = 165; x < 240; ++x) dashes += red_at(x) && !red_at(x + 1);
  EXPECT_GE(dashes, 4);
}

TEST_F(Markers, AReachedTargetHasNoGhost) {
  add(HandleKind::drag, {100, 100});
  const Image reached = draw();
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x)
      ASSERT_FALSE(reached.at(x, y)[0] > 150 && reached.at(x, y)[1] < 120) << x << ", " << y;
}

TEST_F(Markers, VerticesOfSplitsAreOrange) {
  options_ = bare_view();
  options_.layers.remeshed = true;
  snapshot_.original_vertices = 8;
  const Image image = draw();
  EXPECT_LE(difference(canvas_.pixel(image, 200, 200.5), colours().split), 60);
  EXPECT_EQ(difference(canvas_.pixel(image, 100, 100), colours().background), 0);
}

TEST_F(Markers, HandlesKeepTheirSizeWhenZoomed) {
  add(HandleKind::drag);
  const Image image = draw();
  canvas_.view.camera.pixels_per_unit = 12;
  EXPECT_EQ(draw(), image);
}

TEST_F(Markers, AHandleOfNoVertexIsLeftOut) {
  const Image empty = draw();
  add(HandleKind::drag);
  snapshot_.handles[0].vertex = 99;
  EXPECT_EQ(draw(), empty);
}

}  // namespace
}  // namespace foldless
