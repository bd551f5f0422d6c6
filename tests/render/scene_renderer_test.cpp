// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_renderer.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "core/data_path.h"
#include "core/error.h"
#include "render/theme.h"
#include "tests/support/errors.h"
#include "tests/support/pixels.h"
#include "tests/support/temporary_folder.h"

namespace foldless {
namespace {

using test::bare_view;
using test::Canvas;
using test::difference;
using test::undeformed;

Snapshot slanted_square() {
  test::Fixture fixture = test::unit_square();
  fixture.rest << 0.3, 0.8, 0.7, 0.2,  //
      0.2, 0.3, 0.8, 0.7;
  return undeformed(fixture);
}

/// Everything on, a handle off its target.
Snapshot full_scene() {
  Snapshot snapshot = undeformed(test::square_grid(4));
  snapshot.handles.push_back({1, 5, {2.5, 2.5}, HandleKind::drag, 1});
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(1, Edge{0, 5});
  snapshot.original_vertices = 15;
  return snapshot;
}

int partly_covered(const Image& image) {
  int count = 0;
  for (std::size_t p = 3; p < image.pixels.size(); p += 4)
    count += image.pixels[p] > 0 && image.pixels[p] < 255;
  return count;
}

TEST(SceneRenderer, EdgesOfTheFillAreSmoothWithSeveralSamples) {
  ViewOptions options = bare_view();
  options.layers.fill = true;
  options.background = Background::transparent;
  Canvas smooth(100, 100, 100, 4);
  ASSERT_GT(smooth.screen.samples(), 1);
  EXPECT_GT(partly_covered(smooth.draw(slanted_square(), options)), 50);
}

TEST(SceneRenderer, OneSampleDrawsTooWithHardEdges) {
  ViewOptions options = bare_view();
  options.layers.fill = true;
  options.background = Background::transparent;
  Canvas hard(100, 100, 100, 1);
  const Image image = hard.draw(slanted_square(), options);
  EXPECT_EQ(partly_covered(image), 0);
  EXPECT_EQ(hard.pixel(image, 0.5, 0.5)[3], 255);
}

TEST(SceneRenderer, ATransparentBackgroundIsEmptyAndAThemeIsItsColour) {
  Canvas canvas(100, 100, 100);
  ViewOptions options;
  options.background = Background::transparent;
  EXPECT_EQ(canvas.draw(slanted_square(), options).at(0, 0)[3], 0);
  options.background = Background::theme;
  for (const Theme theme : {Theme::dark, Theme::light, Theme::contrast}) {
    options.theme = theme;
    const Image image = canvas.draw(slanted_square(), options);
    EXPECT_LE(difference(image.at(0, 0), canvas_colours(theme).background), 1);
    for (std::size_t p = 3; p < image.pixels.size(); p += 4) ASSERT_GE(image.pixels[p], 254);
  }
}

TEST(SceneRenderer, IndicesGoUpOnlyWithANewRevision) {
  Canvas canvas(64, 64, 16);
  Snapshot snapshot = full_scene();
  for (int frame = 0; frame < 3; ++frame) {
    snapshot.deformed *= 1.01;
    canvas.draw(snapshot, {});
  }
  EXPECT_EQ(canvas.renderer.stats().index_uploads, 1U);
  EXPECT_EQ(canvas.renderer.stats().position_uploads, 3U);
  canvas.draw(full_scene(), {});
  EXPECT_EQ(canvas.renderer.stats().index_uploads, 2U);
}

TEST(SceneRenderer, NewPositionsShowWithoutANewRevision) {
  Canvas canvas(100, 100, 100);
  ViewOptions options = bare_view();
  options.layers.fill = true;
  Snapshot snapshot = slanted_square();
  const glm::vec4& background = canvas_colours(options.theme).background;
  EXPECT_LE(difference(canvas.pixel(canvas.draw(snapshot, options), 0.95, 0.95), background), 1);
  snapshot.deformed.array() += 0.45;
  EXPECT_GT(difference(canvas.pixel(canvas.draw(snapshot, options), 0.95, 0.95), background), 50);
}

TEST(SceneRenderer, TheRestPoseIsTheUndeformedPicture) {
  Canvas canvas(100, 100, 30);
  ViewOptions options;
  options.layers.handles = false;
  Snapshot snapshot = undeformed(test::square_grid(4));
  const Image expected = canvas.draw(snapshot, options);
  snapshot.deformed *= 0.5;
  EXPECT_FALSE(canvas.draw(snapshot, options) == expected);
  options.pose = Pose::rest;
  EXPECT_EQ(canvas.draw(snapshot, options), expected);
}

TEST(SceneRenderer, StaysInsideItsViewport) {
  Canvas canvas(100, 100, 100);
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  canvas.view.viewport = {20, 10, 40, 50};
  canvas.view.camera.pixels_per_unit = 1000;
  const Image image = canvas.draw(slanted_square(), {});
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const bool is_inside = x >= 20 && x < 60 && y >= 40 && y < 90;
      ASSERT_EQ(difference(image.at(x, y), {0, 1, 0, 1}) == 0, !is_inside) << x << ", " << y;
    }
}

TEST(SceneRenderer, LeavesNoErrorAndNoStateBehind) {
  Canvas canvas(64, 64, 16);
  ViewOptions options;
  for (const LayerRow& row : kLayerRows) options.layers.*row.shown = true;
  canvas.renderer.draw(full_scene(), canvas.view, options);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_STENCIL_TEST})
    EXPECT_FALSE(glIsEnabled(off)) << off;
  for (const GLenum unbound :
       {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_TEXTURE_BINDING_2D}) {
    GLint name = -1;
    glGetIntegerv(unbound, &name);
    EXPECT_EQ(name, 0) << unbound;
  }
}

TEST(SceneRenderer, AnEmptySnapshotIsAnEmptyCanvas) {
  Canvas canvas(20, 20, 20);
  const glm::vec4& background = canvas_colours(Theme::dark).background;
  EXPECT_LE(difference(canvas.draw({}, {}).at(10, 10), background), 1);
  const Snapshot without_triangles =
      undeformed({.triangles = Triangles(3, 0), .rest = Points(2, 0)});
  EXPECT_LE(difference(canvas.draw(without_triangles, {}).at(10, 10), background), 1);
}

TEST(SceneRenderer, DrawsTheSameFarFromTheOrigin) {
  Canvas canvas(100, 100, 30);
  Snapshot near = undeformed(test::square_grid(4));
  const Image expected = canvas.draw(near, {});
  test::Fixture shifted = test::square_grid(4);
  shifted.rest.array() += 4096.0 * 4096.0;
  canvas.view.camera.centre += 4096.0 * 4096.0;
  EXPECT_EQ(canvas.draw(undeformed(shifted), {}), expected);
}

TEST(SceneRenderer, SaysWhichShaderIsMissingOrWrong) {
  const Offscreen screen(4, 4);
  const test::TemporaryFolder folder;
  const std::string missing = test::error_of([&] { SceneRenderer renderer(folder.path()); });
  EXPECT_NE(missing.find((folder / "line.vert").string()), std::string::npos) << missing;
  std::filesystem::copy(data_path("shaders"), folder.path());
  std::filesystem::remove(folder / "line.frag");
  folder.write("line.frag", "#version 330 core\nvoid main() { nonsense; }\n");
  const std::string wrong = test::error_of([&] { SceneRenderer renderer(folder.path()); });
  EXPECT_NE(wrong.find((folder / "line.frag").string()), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("nonsense"), std::string::npos) << wrong;
}

}  // namespace
}  // namespace foldless
