// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace foldless {
namespace {

constexpr glm::dvec2 kViewport{1280, 720};

TEST(Camera, PixelsAndWorldPointsComeBack) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Camera camera{{1e3 * uniform(random), 1e3 * uniform(random)},
                        std::pow(10, 4 * uniform(random))};
    const glm::dvec2 pixel{2000 * uniform(random), 2000 * uniform(random)};
    const glm::dvec2 back =
        world_to_pixel(camera, kViewport, pixel_to_world(camera, kViewport, pixel));
    EXPECT_LT(glm::distance(back, pixel), 1e-5);
  }
}

TEST(Camera, WorldYPointsUpAndPixelYDown) {
  const Camera camera{{0, 0}, 10};
  const glm::dvec2 above = world_to_pixel(camera, kViewport, {0, 1});
  EXPECT_DOUBLE_EQ(above.x, 640);
  EXPECT_DOUBLE_EQ(above.y, 350);
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
  const Camera camera{{3, -2}, 40};
  const glm::dvec2 cursor{100, 650};
  const Camera zoomed = zoomed_about(camera, kViewport, cursor, 1.7);
  EXPECT_DOUBLE_EQ(zoomed.pixels_per_unit, 68);
  EXPECT_LT(glm::distance(pixel_to_world(camera, kViewport, cursor),
                          pixel_to_world(zoomed, kViewport, cursor)),
            1e-12);
}

TEST(Camera, ZoomStopsAtItsLimits) {
  Camera camera;
  for (int i = 0; i < 300; ++i) camera = zoomed_about(camera, kViewport, {0, 0}, 10);
  EXPECT_DOUBLE_EQ(camera.pixels_per_unit, 1e120);
  for (int i = 0; i < 300; ++i) camera = zoomed_about(camera, kViewport, {640, 360}, 0.1);
  EXPECT_DOUBLE_EQ(camera.pixels_per_unit, 1e-120);
}

TEST(Camera, PanMovesTheDrawingWithTheMouse) {
  const Camera camera{{3, -2}, 40};
  const glm::dvec2 point{4, 5}, drag{30, -12};
  const glm::dvec2 moved = world_to_pixel(panned(camera, drag), kViewport, point);
  EXPECT_LT(glm::distance(moved, world_to_pixel(camera, kViewport, point) + drag), 1e-9);
}

TEST(Camera, FitLeavesTheMarginAndTouchesIt) {
  const Box box{{-1, 2}, {5, 4}};
  const Camera camera = fit_to_box(box, kViewport, 40);
  const glm::dvec2 low = world_to_pixel(camera, kViewport, box.min);
  const glm::dvec2 high = world_to_pixel(camera, kViewport, box.max);
  EXPECT_NEAR(low.x, 40, 1e-9);
  EXPECT_NEAR(high.x, 1240, 1e-9);
  EXPECT_NEAR(low.y + high.y, 720, 1e-9);
}

TEST(Camera, FitOfAPointIsFinite) {
  const Camera camera = fit_to_box({{2, 2}, {2, 2}}, kViewport, 40);
  EXPECT_DOUBLE_EQ(camera.pixels_per_unit, 100);
  EXPECT_DOUBLE_EQ(camera.centre.x, 2);
}

TEST(Camera, FitWorksInAViewportSmallerThanItsMargins) {
  const Camera camera = fit_to_box({{0, 0}, {1, 1}}, {20, 20}, 40);
  EXPECT_DOUBLE_EQ(camera.pixels_per_unit, 10);
}

TEST(Camera, ClipTransformAgreesWithWorldToPixel) {
  const Camera camera{{1e6, -2e6}, 250};
  const glm::dvec2 origin{1e6 + 1, -2e6 - 1}, point{1e6 + 0.5, -2e6 + 0.25};
  for (const double unit : {1.0, 1e-3, 1e3}) {
    const LocalFrame local{origin, unit};
    const ClipTransform clip = clip_transform(camera, kViewport, local);
    const glm::dvec2 place =
        glm::dvec2(clip.scale) * glm::dvec2(local.to_local(point)) + glm::dvec2(clip.offset);
    const glm::dvec2 pixel = 0.5 * kViewport * (glm::dvec2(1, -1) * place + 1.0);
    EXPECT_LT(glm::distance(pixel, world_to_pixel(camera, kViewport, point)), 1e-3) << unit;
  }
}

}  // namespace
}  // namespace foldless
