// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/line_layer.h"

#include <gtest/gtest.h>

#include "render/theme.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

using test::bare_view;
using test::Canvas;
using test::difference;

/// How much of a column of pixels is covered by lines of a colour, in pixels.
double covered_length(const Image& image, int x, const glm::vec4& below, const glm::vec4& line) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    sum += (image.at(x, y)[1] / 255.0 - below.g) / (line.g - below.g);
  return sum;
}

TEST(Lines, TheWireframeRunsAlongInteriorEdgesOnly) {
  Canvas canvas(100, 100, 100);
  ViewOptions options = bare_view();
  options.layers.wireframe = true;
  const Image image = canvas.draw(test::undeformed(test::unit_square()), options);
  const CanvasColours& colours = canvas_colours(options.theme);
  for (const double t : {0.1, 0.35, 0.5, 0.8})
    EXPECT_GT(difference(canvas.pixel(image, t + 0.005, t + 0.005), colours.background), 40) << t;
  for (const double t : {0.1, 0.3, 0.9}) {
    EXPECT_EQ(difference(canvas.pixel(image, t, 1 - t), colours.background), 0) << t;
    EXPECT_EQ(difference(canvas.pixel(image, t, 0.005), colours.background), 0) << t;
  }
}

TEST(Lines, AreAsWideAtEveryZoomAndGrowWithTheScale) {
  const CanvasColours& colours = canvas_colours(Theme::dark);
  for (const double scale : {1.0, 2.0})
    for (const double zoom : {40.0, 61.7, 150.0}) {
      Canvas canvas(200, 100, zoom);
      canvas.view.camera.centre = {0.5, 0};  // on the lower side of the square
      ViewOptions options = bare_view();
      options.layers.boundary = true;
      options.ui_scale = scale;
      test::Fixture fixture = test::unit_square();
      fixture.rest.row(1) *= 10;
      const Image image = canvas.draw(test::undeformed(fixture), options);
      EXPECT_NEAR(covered_length(image, 100, colours.background, colours.text), 2 * scale, 0.1)
          << "zoom " << zoom << ", scale " << scale;
    }
}

TEST(Lines, FlippedEdgesAreBlue) {
  Canvas canvas(100, 100, 100);
  Snapshot snapshot = test::undeformed(test::unit_square());
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(1, Edge{0, 2});
  ViewOptions options = bare_view();
  options.layers.remeshed = true;
  const Image image = canvas.draw(snapshot, options);
  const std::uint8_t* pixel = canvas.pixel(image, 0.5, 0.5);
  EXPECT_GT(pixel[2], 200);
  EXPECT_GT(pixel[2], 2 * pixel[0]);
}

TEST(Lines, TheRestGhostIsThereWhereTheMeshNoLongerIs) {
  Canvas canvas(300, 100, 100);
  Snapshot snapshot = test::undeformed(test::unit_square());
  snapshot.deformed.row(0).array() += 1.5;
  ViewOptions options = bare_view();
  options.layers.rest = true;
  const auto ghost_at = [&](const Image& image) {
    return difference(canvas.pixel(image, 0.999, 0.5), canvas_colours(options.theme).background);
  };
  EXPECT_GT(ghost_at(canvas.draw(snapshot, options)), 40);
  options.layers.rest = false;
  EXPECT_EQ(ghost_at(canvas.draw(snapshot, options)), 0);
}

}  // namespace
}  // namespace foldless
