// SPDX-License-Identifier: GPL-3.0-or-later
// What lies behind a sheet of the mesh does not show through it.
#include <gtest/gtest.h>

#include <array>

#include "render/layer_lists.h"
#include "tests/support/pixels.h"
#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

/// The middle of a canvas on the crossing at the origin.
class Sheets : public testing::Test {
 protected:
  Sheets() { canvas_.view.camera.centre = {0, 0}; }

  /// The colours of a triangle depend on itself alone.
  static ViewOptions every_edge() {
    ViewOptions options = bare_view();
    options.layers.heat = options.layers.wireframe = options.layers.boundary = true;
    options.layers.remeshed = true;
    options.heat_scale = {1, 4};
    return options;
  }

  /// With an edge across both sheets of the crossing flipped and all vertices made by splits.
  static Snapshot remeshed(Snapshot snapshot) {
    std::vector<Edge> flipped;
    for (const auto& t : snapshot.triangles->colwise()) flipped.push_back({t[0], t[2]});
    snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(flipped);
    snapshot.original_vertices = 0;
    return snapshot;
  }

  /// The part of a crossing ribbon with x > 0, or < 0, alone.
  static Snapshot half(bool right) {
    const Fixture f = right ? ribbon(20, 0, 1.6, 0.15) : ribbon(20, -1.6, 0, 0.15);
    return remeshed(posed(f, along(f.rest, loop)));
  }

  /// How many pixels of the crossing, inside of one sheet, are not as that sheet has them alone.
  int differing(const Image& image, const Image& alone, bool right) const {
    int count = 0;
    for (int y = -60; y < 60; ++y)
      for (int x = -60; x < 60; ++x) {
        // The sheets cross at right angles, along the diagonals.
        const double across = (right ? x + y : x - y) / std::sqrt(2.0);
        if (std::abs(across) > 0.15 * kScale - 4) continue;
        count += difference(image.at(200 + x, 200 + y), alone.at(200 + x, 200 + y)) > 2;
      }
    return count;
  }

  static constexpr double kScale = 400;
  Canvas canvas_{400, 400, kScale};
};

TEST_F(Sheets, WireOutlineFlippedEdgesAndSplitsOfTheSheetBehindAreHidden) {
  Snapshot snapshot = remeshed(crossing_ribbon());
  for (const bool right : {true, false}) {
    snapshot.handles[1].depth = right ? 1 : -1;
    const Image image = canvas_.draw(snapshot, every_edge());
    const Image front = canvas_.draw(half(right), every_edge());
    const Image back = canvas_.draw(half(!right), every_edge());
    EXPECT_EQ(differing(image, front, right), 0) << right;
    EXPECT_GT(differing(image, back, !right), 3000) << "the test can fail";
  }
}

TEST_F(Sheets, ThroughWhatIsTransparentOneSeesWhatIsBehind) {
  Snapshot snapshot = crossing_ribbon();
  ViewOptions options = bare_view();
  options.layers.fill = true;
  Image picture(64, 8);
  // Opaque at the left end of the ribbon only.
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 32; ++x) picture.at(x, y)[0] = picture.at(x, y)[3] = 255;
  canvas_.renderer.set_texture(picture);
  const Image image = canvas_.draw(snapshot, options);
  EXPECT_EQ(difference(canvas_.pixel(image, 0, 0), {1, 0, 0, 1}), 0)
      << "the right sheet is in front and clear";
}

TEST_F(Sheets, IndicesGoUpAgainOnlyWhenAnotherSheetIsInFront) {
  Snapshot snapshot = crossing_ribbon();
  const auto uploads = [&] {
    canvas_.draw(snapshot, {});
    return canvas_.renderer.stats().index_uploads;
  };
  EXPECT_EQ(uploads(), 1U);
  snapshot.deformed *= 1.001;
  EXPECT_EQ(uploads(), 1U);
  snapshot.handles[0].depth = 1;
  EXPECT_EQ(uploads(), 2U);
  snapshot.handles[0].depth = 2;
  EXPECT_EQ(uploads(), 2U);
}

TEST_F(Sheets, AreNotInTheRestPose) {
  Snapshot snapshot = crossing_ribbon();
  ViewOptions options;
  options.pose = Pose::rest;
  options.layers.handles = false;
  const Image before = canvas_.draw(snapshot, options);
  snapshot.handles[0].depth = 1;
  EXPECT_EQ(canvas_.draw(snapshot, options), before);
}

TEST(LayerLists, AreSortedByLayerAndStable) {
  const LayerLists lists = layer_lists({1, 0, 3, 1, 0}, 5);
  EXPECT_EQ(lists.order, (std::vector<int>{1, 4, 0, 3, 2}));
  EXPECT_EQ(lists.first, (std::vector<std::size_t>{0, 2, 4, 4, 5, 5}));
  EXPECT_EQ(layer_lists({}, 1).first, (std::vector<std::size_t>{0, 0}));
}

}  // namespace
}  // namespace foldless::test
