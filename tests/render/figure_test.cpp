// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/figure_panes.h"
#include "render/legend.h"
#include "render/theme.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

Snapshot pulled_sheet() {
  Snapshot snapshot = test::undeformed(test::square_grid(5));
  snapshot.deformed.col(24) += Vec2(1, 1);
  snapshot.handles.push_back({1, 24, {6, 6}, HandleKind::drag, 1});
  return snapshot;
}

FigureOptions small_figure() {
  FigureOptions options;
  options.width = 320;
  options.height = 240;
  return options;
}

/// Pixels from column `left` to before `right` that are within 12 of a colour.
int count_of(const Image& image, const glm::vec4& colour, int left, int right) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = left; x < right; ++x) count += test::difference(image.at(x, y), colour) <= 12;
  return count;
}

TEST(Figure, HasTheSizeAskedForAndTheLightTheme) {
  const Image image = render_figure(pulled_sheet(), small_figure());
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 240);
  EXPECT_LE(test::difference(image.at(1, 1), canvas_colours(Theme::light).background), 1);
}

TEST(Figure, BothShowsConstrainedVerticesGreenAndTargetsRedInEachPane) {
  FigureOptions options = small_figure();
  options.view = FigureView::both;
  const Image image = render_figure(pulled_sheet(), options);
  const CanvasColours& colours = canvas_colours(Theme::light);
  for (const int left : {0, 160}) {
    EXPECT_GT(count_of(image, colours.handle, left, left + 160), 30);
    EXPECT_GT(count_of(image, colours.target, left, left + 160), 10);
  }
}

TEST(Figure, AMiniatureShowsTheCheckerboardBesideTheWireframe) {
  FigureOptions options = small_figure();
  options.style.layers.fill = false;
  options.style.layers.handles = false;
  const CanvasColours& colours = canvas_colours(Theme::light);
  const int miniature = 320 - 96;
  const Image without = render_figure(pulled_sheet(), options);
  EXPECT_EQ(count_of(without, colours.checker_dark, 0, 320), 0);
  options.miniature = true;
  const Image with = render_figure(pulled_sheet(), options);
  EXPECT_EQ(count_of(with, colours.checker_dark, 0, miniature), 0);
  EXPECT_GT(count_of(with, colours.checker_dark, miniature, 320), 50);
  options.view = FigureView::rest;
  EXPECT_EQ(count_of(render_figure(pulled_sheet(), options), colours.checker_dark, 0, 320), 0)
      << "the rest mesh alone has none";
}

TEST(Figure, FitsMeshAndTargetsIntoThePicture) {
  const Snapshot snapshot = pulled_sheet();
  const Box box = frame_of(snapshot, FigureView::deformed);
  EXPECT_EQ(box.min, glm::dvec2(0, 0));
  EXPECT_EQ(box.max, glm::dvec2(6, 6));
  EXPECT_EQ(frame_of(test::undeformed(test::square_grid(3)), FigureView::rest).max,
            glm::dvec2(2, 2));
  FigureOptions options = small_figure();
  options.style.background = Background::transparent;
  const Image image = render_figure(snapshot, options);
  for (int x = 0; x < 320; ++x) {
    ASSERT_EQ(image.at(x, 0)[3], 0);
    ASSERT_EQ(image.at(x, 239)[3], 0);
  }
}

TEST(Figure, HeatComesWithALegendAtTheRight) {
  FigureOptions options = small_figure();
  options.style.layers.heat = true;
  const Image image = render_figure(pulled_sheet(), options);
  const int x = 320 - legend_width(1) + 12;
  EXPECT_LT(test::place_on_viridis(image.at(x, 185)), 0.1);
  EXPECT_GT(test::place_on_viridis(image.at(x, 55)), 0.9);
}

TEST(Figure, OneRendererDrawsManyFiguresOfAnySize) {
  FigureRenderer renderer;
  FigureOptions options = small_figure();
  const Image first = renderer.render(pulled_sheet(), options);
  options.width = 100;
  options.texture = whole_texture(Image(4, 4));
  EXPECT_EQ(renderer.render(pulled_sheet(), options).width, 100);
  EXPECT_EQ(renderer.render(pulled_sheet(), small_figure()), first);
  EXPECT_EQ(render_figure(pulled_sheet(), small_figure()), first);
}

TEST(Figure, AGivenFrameHoldsTheCameraStill) {
  FigureOptions options = small_figure();
  options.style.layers.handles = false;
  options.frame = Box{{0, 0}, {10, 10}};
  Snapshot snapshot = test::undeformed(test::square_grid(5));
  const Image before = render_figure(snapshot, options);
  snapshot.handles.push_back({1, 0, {500, 500}, HandleKind::drag, 1});
  EXPECT_EQ(render_figure(snapshot, options), before);
}

TEST(Figure, RefusesASizeThatCannotBeDrawn) {
  FigureOptions options = small_figure();
  options.width = 1 << 24;
  EXPECT_THROW(render_figure(pulled_sheet(), options), Error);
}

}  // namespace
}  // namespace foldless
