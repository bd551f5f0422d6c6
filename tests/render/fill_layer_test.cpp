// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_layer.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

using test::bare_view;
using test::Canvas;
using test::difference;
using test::undeformed;

ViewOptions only_fill(Background background = Background::theme) {
  ViewOptions options = bare_view();
  options.layers.fill = true;
  options.background = background;
  return options;
}

/// A grid of n × n vertices whose box is width × height from the origin.
Snapshot sheet(int n, double width, double height) {
  test::Fixture fixture = test::square_grid(n);
  fixture.rest.row(0) *= width / (n - 1);
  fixture.rest.row(1) *= height / (n - 1);
  return undeformed(fixture);
}

Image noise(int width, int height, bool is_opaque) {
  std::mt19937 random(3);
  Image image(width, height);
  for (auto& byte : image.pixels) byte = static_cast<std::uint8_t>(random());
  for (std::size_t p = 3; is_opaque && p < image.pixels.size(); p += 4) image.pixels[p] = 255;
  return image;
}

TEST(FillLayer, TheUndeformedRenderEqualsTheSourceImage) {
  const Image source = noise(64, 48, true);
  Canvas canvas(64, 48, 1);
  canvas.renderer.set_texture(source);
  const Image drawn = canvas.draw(sheet(9, 64, 48), only_fill());
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_LE(difference(drawn.at(x, y), source.at(x, y)), 1) << x << ", " << y;
}

TEST(FillLayer, ATextureThatComesBitByBitIsSeenAtOnceAndEqualsTheSourceImageInTheEnd) {
  const Image source = noise(64, 48, true);
  Canvas canvas(64, 48, 1);
  canvas.renderer.begin_texture(*whole_texture(source));
  EXPECT_FALSE(canvas.renderer.has_whole_texture());
  const Image first = canvas.draw(sheet(9, 64, 48), only_fill());
  EXPECT_GT(first.at(32, 24)[0], 90) << "the mean of the noise, not black";
  int bits = 0;
  for (; canvas.renderer.upload_texture(200); ++bits) EXPECT_LT(bits, 30);
  EXPECT_GT(bits, 15);
  EXPECT_TRUE(canvas.renderer.has_whole_texture());
  const Image drawn = canvas.draw(sheet(9, 64, 48), only_fill());
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_LE(difference(drawn.at(x, y), source.at(x, y)), 1) << x << ", " << y;
}

TEST(FillLayer, TransparentPixelsOfTheImageStayTransparent) {
  const Image source = noise(40, 30, false);
  Canvas canvas(40, 30, 1);
  canvas.renderer.set_texture(source);
  const Image drawn = canvas.draw(sheet(5, 40, 30), only_fill(Background::transparent));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const std::uint8_t *pixel = drawn.at(x, y), *original = source.at(x, y);
      ASSERT_NEAR(pixel[3], original[3], 2) << x << ", " << y;
      // Colours are only as exact as eight bits of premultiplied colour are.
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(pixel[c] * pixel[3] / 255.0, original[c] * original[3] / 255.0, 3);
    }
}

TEST(FillLayer, ATriangleMeshShowsNoSeams) {
  Image white(8, 8);
  std::fill(white.pixels.begin(), white.pixels.end(), std::uint8_t{255});
  Canvas canvas(200, 200, 200);
  canvas.renderer.set_texture(white);
  Snapshot snapshot = sheet(23, 1, 1);
  const Vec2 middle(0.5, 0.5);
  Mat2 turn;
  turn << 1, 0.3, -0.3, 1;
  snapshot.deformed = (turn * (snapshot.deformed.colwise() - middle)).colwise() + middle;
  const Image drawn = canvas.draw(snapshot, only_fill(Background::transparent));
  for (int y = 60; y < 140; ++y)
    for (int x = 60; x < 140; ++x)
      ASSERT_EQ(difference(drawn.at(x, y), {1, 1, 1, 1}), 0) << x << ", " << y;
}

TEST(FillLayer, TheCheckerboardHasItsTwoColoursWhereExpected) {
  Canvas canvas(200, 200, 200);
  ViewOptions options = only_fill();
  options.checker_squares = 4;
  const Image image = canvas.draw(sheet(2, 1, 1), options);
  const CanvasColours& colours = canvas_colours(options.theme);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const auto& expected = (i + j) % 2 == 0 ? colours.checker_light : colours.checker_dark;
      const auto* pixel = canvas.pixel(image, (i + 0.5) / 4, (j + 0.5) / 4);
      EXPECT_LE(difference(pixel, expected), 1) << i << ", " << j;
    }
}

TEST(FillLayer, TheCheckerboardFollowsTheDeformation) {
  Canvas canvas(200, 100, 100);
  ViewOptions options = only_fill();
  options.checker_squares = 2;
  Snapshot snapshot = sheet(3, 1, 1);
  snapshot.deformed.row(0) *= 2;
  const Image image = canvas.draw(snapshot, options);
  const CanvasColours& colours = canvas_colours(options.theme);
  EXPECT_LE(difference(canvas.pixel(image, 0.9, 0.25), colours.checker_light), 1);
  EXPECT_LE(difference(canvas.pixel(image, 1.1, 0.25), colours.checker_dark), 1);
}

TEST(FillLayer, SquaresTooFineToSeeBecomeTheirMeanWithoutMoire) {
  Canvas canvas(100, 100, 100);
  ViewOptions options = only_fill();
  options.checker_squares = 733;
  const Image image = canvas.draw(sheet(2, 1, 1), options);
  const CanvasColours& colours = canvas_colours(options.theme);
  const glm::vec4 mean = 0.5F * (colours.checker_light + colours.checker_dark);
  for (int y = 10; y < 90; ++y)
    for (int x = 10; x < 90; ++x) ASSERT_LE(difference(image.at(x, y), mean), 6);
}

TEST(FillLayer, TheCheckerboardComesBackWithoutATexture) {
  Canvas canvas(50, 50, 50);
  const Image before = canvas.draw(sheet(3, 1, 1), only_fill());
  canvas.renderer.set_texture(noise(8, 8, true));
  const Image textured = canvas.draw(sheet(3, 1, 1), only_fill());
  canvas.renderer.clear_texture();
  EXPECT_FALSE(before == textured);
  EXPECT_EQ(before, canvas.draw(sheet(3, 1, 1), only_fill()));
}

TEST(FillLayer, RefusesAnEmptyTextureAndKeepsTheOldOne) {
  Canvas canvas(50, 50, 50);
  canvas.renderer.set_texture(noise(8, 8, true));
  const Image before = canvas.draw(sheet(3, 1, 1), only_fill());
  EXPECT_THROW(canvas.renderer.set_texture(Image{}), Error);
  EXPECT_EQ(before, canvas.draw(sheet(3, 1, 1), only_fill()));
}

TEST(FillLayer, HeatColoursRiseWithTheDistortion) {
  Canvas canvas(350, 50, 10);
  test::Fixture fixture = test::square_grid(6);
  Snapshot snapshot = undeformed(fixture);
  for (auto column : snapshot.deformed.colwise()) column.x() *= 1 + 0.5 * (column.x() + 1);
  ViewOptions options = bare_view();
  options.layers.heat = true;
  const Image image = canvas.draw(snapshot, options);
  ASSERT_TRUE(canvas.renderer.heat_range());
  double last = -1;
  for (int k = 0; k < 5; ++k) {  // below the diagonal of every cell of the lowest row
    const double left = k * (1 + 0.5 * (k + 1)), right = (k + 1) * (1 + 0.5 * (k + 2));
    const double place =
        test::place_on_viridis(canvas.pixel(image, left + 0.8 * (right - left), 0.25));
    EXPECT_GT(place, last) << k;
    last = place;
  }
  EXPECT_NEAR(last, 1, 0.01);
}

TEST(FillLayer, HeatRangeIsThereWithTheLayerOnly) {
  Canvas canvas(50, 50, 50);
  ViewOptions options = only_fill();
  options.layers.heat = true;
  canvas.draw(sheet(3, 1, 1), options);
  EXPECT_TRUE(canvas.renderer.heat_range());
  options.layers.heat = false;
  canvas.draw(sheet(3, 1, 1), options);
  EXPECT_FALSE(canvas.renderer.heat_range());
}

TEST(FillLayer, HeatHoldsForMoreTrianglesThanOneRowOfTheColourTable) {
  Canvas canvas(400, 400, 10);
  test::Fixture fixture = test::square_grid(41);
  Snapshot snapshot = undeformed(fixture);
  const int corner = 41 * 41 - 1;
  snapshot.deformed.col(corner) += Vec2(-0.6, -0.2);
  ViewOptions options = bare_view();
  options.layers.heat = true;
  const Image image = canvas.draw(snapshot, options);
  EXPECT_LE(difference(canvas.pixel(image, 0.5, 0.3), glm::vec4(viridis(0), 1)), 1);
  EXPECT_GT(test::place_on_viridis(canvas.pixel(image, 39.4, 39.5)), 0.5);
}

TEST(FillLayer, FoldedTrianglesAreOneColourWhateverLayersAreOn) {
  Snapshot snapshot = undeformed(test::unit_square());
  snapshot.deformed.col(3) = Vec2(0.9, 0.3);  // triangle (0, 2, 3) lies over (0, 1, 2)
  snapshot.folded_triangles = 1;
  Canvas canvas(100, 100, 100);
  ViewOptions options = bare_view();
  for (const bool is_filled : {true, false}) {
    options.layers.fill = is_filled;
    for (const Theme theme : {Theme::dark, Theme::light, Theme::contrast}) {
      options.theme = theme;
      const glm::vec4& yellow = canvas_colours(theme).folded;
      const Image image = canvas.draw(snapshot, options);
      EXPECT_LE(difference(canvas.pixel(image, 0.65, 0.45), yellow), 1);
      EXPECT_GT(difference(canvas.pixel(image, 0.8, 0.1), yellow), 50) << "not folded";
      EXPECT_GT(yellow.r, 0.8F);
      EXPECT_GT(yellow.g, 0.7F);
      EXPECT_LT(yellow.b, 0.2F);
    }
  }
  snapshot.deformed = *snapshot.rest;
  snapshot.folded_triangles = 0;
  options.layers.fill = true;
  EXPECT_GT(difference(canvas.pixel(canvas.draw(snapshot, options), 0.65, 0.45),
                       canvas_colours(options.theme).folded),
            50);
}

}  // namespace
}  // namespace foldless
