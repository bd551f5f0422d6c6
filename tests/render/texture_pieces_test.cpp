// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_pieces.h"

#include <gtest/gtest.h>

#include "tests/support/layered_files.h"
#include "tests/support/pixels.h"
#include "tests/support/ribbons.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// A red and a green layer, which overlap from (20, 20) to (40, 40) of a canvas of 60 × 60.
LayeredImage two_blocks() {
  return painting_of(60, 60,
                     {block("Red", 0, 20, plain(40, 40, {255, 0, 0, 255})),
                      block("Green", 20, 0, plain(40, 40, {0, 255, 0, 255}))});
}

class TexturePiecesOfParts : public testing::Test {
 protected:
  TexturePiecesOfParts() {
    Fixture red = square_grid(9), green = red;
    red.rest *= 40.0 / 8;
    green.rest = red.rest.array() + 20;
    const int vertices = static_cast<int>(red.rest.cols());
    const Fixture f = both(red, green);
    snapshot_ = undeformed(f);
    parts_ = std::make_shared<const MeshParts>(
        MeshParts{{"Red", 0, vertices, 0}, {"Green", vertices, vertices, 1}});
    options_ = bare_view();
    options_.layers.fill = true;
    options_.background = Background::transparent;
    canvas_.renderer.set_parts(parts_);
  }

  void expect_colour(const Vec2& at, const glm::vec4& colour) {
    const Image image = canvas_.draw(snapshot_, options_);
    EXPECT_LE(difference(canvas_.pixel(image, at.x(), at.y()), colour), 1) << at.transpose();
  }

  Canvas canvas_{60, 60, 1};
  Snapshot snapshot_;
  std::shared_ptr<const MeshParts> parts_;
  ViewOptions options_;
};

const glm::vec4 kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1}, kClear{0, 0, 0, 0};

TEST_F(TexturePiecesOfParts, EachPartShowsItsLayerInItsPlace) {
  canvas_.renderer.set_texture(*pieces_for(*parts_, layer_pieces(two_blocks())),
                               Box{{0, 0}, {60, 60}});
  expect_colour({10.5, 10.5}, kRed);
  expect_colour({50.5, 50.5}, kGreen);
  expect_colour({30.5, 30.5}, kGreen);
}

TEST_F(TexturePiecesOfParts, DepthsOfHandlesAreAddedToThoseOfParts) {
  canvas_.renderer.set_texture(*pieces_for(*parts_, layer_pieces(two_blocks())),
                               Box{{0, 0}, {60, 60}});
  snapshot_.handles = {{.id = 0, .vertex = 0, .depth = 0.5}};
  expect_colour({30.5, 30.5}, kGreen);
  snapshot_.handles[0].depth = 1.5;
  expect_colour({30.5, 30.5}, kRed);
}

TEST_F(TexturePiecesOfParts, WhatIsMissingIsNotSeen) {
  LayeredImage painting = two_blocks();
  painting.layers.pop_back();
  canvas_.renderer.set_texture(*pieces_for(*parts_, layer_pieces(painting)), Box{{0, 0}, {60, 60}});
  expect_colour({30.5, 30.5}, kRed);
  expect_colour({50.5, 50.5}, kClear);
}

TEST_F(TexturePiecesOfParts, OnePictureFillsAllParts) {
  canvas_.renderer.set_texture(plain(60, 60, {255, 0, 0, 255}), Box{{0, 0}, {60, 60}});
  expect_colour({10.5, 10.5}, kRed);
  expect_colour({50.5, 50.5}, kRed);
}

TEST(LoadTexture, TakesLayersOnlyWhereThereAreParts) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.ora", ora_of(two_blocks()));
  const MeshParts parts{{"Green", 0, 3, 0}, {"Blue", 3, 3, 1}};
  EXPECT_EQ(load_texture(file, nullptr).pieces->size(), 1U);
  const LoadedTexture by_part = load_texture(file, &parts);
  ASSERT_EQ(by_part.pieces->size(), 2U);
  EXPECT_EQ(by_part.pieces->at(0).levels->front().at(5, 5)[1], 255);
  EXPECT_EQ(by_part.pieces->at(1).levels, nullptr);
  EXPECT_EQ(by_part.notices,
            std::vector<std::string>{"a.ora has no layer 'Blue' any more: its part is not seen"});
  save_png(folder / "a.png", plain(5, 5, {1, 2, 3, 255}));
  EXPECT_EQ(load_texture(folder / "a.png", &parts).pieces->size(), 1U);
}

}  // namespace
}  // namespace foldless::test
