// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <sstream>

#include "app/cli/problem.h"
#include "app/export/texture_place.h"
#include "core/files/mesh_io.h"
#include "render/figure.h"
#include "tests/app/cli/command.h"
#include "tests/support/pictures.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

using test::Ended;
using test::TemporaryFolder;

TEST(MeshCall, PrintsWhatTheMeshIsLike) {
  const TemporaryFolder folder;
  test::write_ring(folder / "ring.png", 200);
  const Ended ended = test::run({"mesh", folder / "ring.png", "-o", folder / "ring.obj"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const LoadedMesh mesh = read_mesh(folder / "ring.obj");
  EXPECT_TRUE(mesh.notices.empty());
  const std::string sizes = std::to_string(mesh.points.cols()) + " vertices, " +
                            std::to_string(mesh.triangles.cols()) + " triangles, smallest angle 2";
  EXPECT_TRUE(ended.out.starts_with(sizes)) << ended.out;
  EXPECT_TRUE(ended.out.ends_with(" degrees, 2 parts, 1 hole\n")) << ended.out;
  EXPECT_GT(mesh.points.cols(), 1500);
  EXPECT_LT(mesh.points.cols(), 2500);
}

TEST(MeshCall, OptionsChangeTheMesh) {
  const TemporaryFolder folder;
  test::write_ring(folder / "ring.png", 100);
  const auto printed = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"mesh", folder / "ring.png", "-o", folder / "ring.obj"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = test::run(arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return ended.out;
  };
  const std::string plain = printed({});
  EXPECT_EQ(printed({}), plain);
  EXPECT_NE(printed({"--edge-length", "10"}), plain);
  EXPECT_NE(printed({"--min-angle", "30"}), plain);
  EXPECT_NE(printed({"--simplify", "3"}), plain);
  EXPECT_NE(printed({"--threshold", "0.9"}), plain);
  const std::string wide = printed({"--margin", "12"});
  EXPECT_TRUE(wide.ends_with(" 1 part, 0 holes\n")) << "the ring grows over its hole: " << wide;
}

TEST(MeshCall, TextureCoordinatesOfAnObjAreThoseOfTheImage) {
  const TemporaryFolder folder;
  test::write_ring(folder / "ring.png", 64);
  ASSERT_EQ(test::run({"mesh", folder / "ring.png", "-o", folder / "ring.obj"}).status, 0);
  const Points points = read_mesh(folder / "ring.obj").points;
  std::istringstream lines(test::read_text(folder / "ring.obj"));
  std::string word;
  int v = 0;
  while (lines >> word)
    if (word == "vt") {
      double s = 0, t = 0;
      lines >> s >> t;
      EXPECT_NEAR(64 * s, points(0, v), 1e-9);
      EXPECT_NEAR(64 * t, points(1, v), 1e-9);
      ++v;
    }
  EXPECT_EQ(v, points.cols());
}

TEST(MeshCall, TheUndeformedSceneIsTheImageToWithinOneGreyLevel) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "scenes");
  const Image source = test::painted(test::ring_map(240));
  save_png(folder.path() / "ring.png", source);
  ASSERT_EQ(test::run({"mesh", folder / "ring.png", "-o", folder / "scenes/ring.json"}).status, 0);
  // The scene names its image by a path relative to itself.
  EXPECT_NE(test::read_text(folder / "scenes/ring.json").find("\"../ring.png\""),
            std::string::npos);
  const auto loaded = load_scene_file(folder / "scenes/ring.json");
  ASSERT_TRUE(loaded.scene.texture_box.has_value());
  EXPECT_EQ(loaded.scene.texture_box->max, Vec2(240, 240));

  FigureOptions figure;
  figure.width = figure.height = 240;
  figure.style = test::bare_view();
  figure.style.layers.fill = true;
  figure.style.background = Background::transparent;
  figure.texture = whole_texture(source);
  figure.texture_place = texture_place(loaded.scene);
  // The figure keeps a margin round its frame: one pixel a pixel of the image.
  figure.frame = Box{{28, 28}, {212, 212}};
  const auto draw = [&] {
    save_png(folder.path() / "drawn.png",
             render_figure(test::undeformed({loaded.scene.triangles, loaded.scene.rest}), figure));
  };
  ASSERT_TRUE(test::in_own_process(draw));
  const Image drawn = load_image(folder.path() / "drawn.png");
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x) {
      const std::uint8_t *pixel = drawn.at(x, y), *original = source.at(x, y);
      ASSERT_TRUE(original[3] < 255 || test::difference(pixel, original) <= 1) << x << ' ' << y;
    }
}

TEST(MeshCall, RefusesInOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  save_png(folder / "clear.png", Image(20, 20));
  test::write_ring(folder / "ring.png", 50);
  test::write_text(folder / "bad.png", "pixels");
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls{
      {{"mesh", folder / "clear.png", "-o", folder / "out.json"}, "transparent everywhere"},
      {{"mesh", folder / "bad.png", "-o", folder / "out.json"}, "is not a PNG"},
      {{"mesh", folder / "none.png", "-o", folder / "out.json"}, "none.png"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.gif"}, "out.gif: end the name"},
      {{"mesh", folder / "ring.png"}, "--output"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--edge-length", "0"},
       "edge length"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--margin", "-1"}, "margin"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--min-angle", "60"}, "angle"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--simplify", "nan"}, "simpl"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--threshold", "2"}, "threshold"},
      {{"mesh", folder / "ring.png", "-o", folder / "out.json", "--margin", "wide"}, "margin"},
  };
  for (const auto& [arguments, words] : calls) {
    const Ended ended = test::run(arguments);
    EXPECT_EQ(ended.status, 2) << words;
    EXPECT_EQ(ended.out, "");
    EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    EXPECT_EQ(test::names_in(folder.path()).size(), 3U);
  }
}

TEST(MeshCall, TellsOfSpecksThatAreLeftOut) {
  const TemporaryFolder folder;
  AlphaMap map = test::ring_map(100);
  map.values[3 * 100 + 3] = 255;
  save_png(folder / "ring.png", test::painted(map));
  const Ended ended = test::run({"mesh", folder / "ring.png", "-o", folder / "ring.json"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "foldless: note: 1 speck of a few pixels left out\n");
}

}  // namespace
}  // namespace foldless
