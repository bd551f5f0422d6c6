// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/godot.h"

#include <gtest/gtest.h>

#include "app/export/engine_mesh.h"
#include "tests/app/export/bent_grid.h"
#include "tests/app/export/godot_scene_reader.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::GodotSceneReader;

const EngineUnits kUnitsOfScene{{1.5, 1.5}, 0.003};

BakedAnimation held(const BakedAnimation& animation) { return in_pixels(animation, kUnitsOfScene); }

/// The largest distance between the corners of a polygon's triangles, y down, and an animation's.
double largest_distance(const json& node, const json& polygon, const BakedAnimation& animation,
                        const Points& expected) {
  double largest = 0;
  EXPECT_EQ(node["polygons"].size(), static_cast<std::size_t>(animation.triangles.cols()));
  for (std::size_t t = 0; t < node["polygons"].size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = 2 * node["polygons"][t].at(k).get<std::size_t>();
      const Vec2 seen(polygon.at(at).get<float>(), -polygon.at(at + 1).get<float>());
      const int v = animation.triangles(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(t));
      largest = std::max(largest, (seen - expected.col(v)).norm());
    }
  return largest;
}

TEST(Godot, ItsTrackHasThePlacesOfEveryFrame) {
  for (const bool loops : {true, false}) {
    const BakedAnimation animation = test::grid_that_bends(loops);
    const GodotSceneReader read(godot_scene(held(animation), test::one_piece(animation), "walk"));
    const json node = read.find("node", "name", "Piece1").properties;
    const json track = read.find("sub_resource", "type", "Animation").properties;
    EXPECT_EQ(track["tracks/0/type"], "value");
    EXPECT_EQ(track["tracks/0/path"], "Piece1:polygon");
    EXPECT_EQ(track["tracks/0/interp"], 1) << "linear";
    EXPECT_EQ(track["loop_mode"], loops ? 1 : 0);
    const json keys = track["tracks/0/keys"];
    EXPECT_EQ(keys["update"], 0) << "continuous";
    const auto times = keys["times"].get<std::vector<double>>();
    EXPECT_EQ(times, loops ? (std::vector<double>{0, 0.1, 0.15, 0.3, 0.4})
                           : (std::vector<double>{0, 0.1, 0.15, 0.3}));
    EXPECT_EQ(track["length"], times.back());
    EXPECT_EQ(keys["transitions"], json(std::vector<int>(times.size(), 1)));
    ASSERT_EQ(keys["values"].size(), times.size());
    for (std::size_t k = 0; k < times.size(); ++k) {
      const json& places = keys["values"][k];
      EXPECT_EQ(largest_distance(node, places, animation, held(animation).frames[k % 4].deformed),
                0);
      const Points exact =
          (animation.frames[k % 4].deformed.colwise() - kUnitsOfScene.origin) / kUnitsOfScene.pixel;
      EXPECT_LT(largest_distance(node, places, animation, exact), 1e-6 * 1000) << k;
    }
    EXPECT_EQ(node["polygon"], keys["values"][0]);
  }
}

TEST(Godot, ThePlayerPlaysItAtOnce) {
  const BakedAnimation animation = test::grid_that_bends(true);
  const GodotSceneReader read(godot_scene(animation, test::one_piece(animation), "wa/lk"));
  EXPECT_EQ(read.sections.front().tag, "gd_scene");
  EXPECT_EQ(read.sections.front().attributes["format"], 3);
  const json player = read.find("node", "name", "AnimationPlayer").properties;
  EXPECT_EQ(player["autoplay"], "wa_lk");
  EXPECT_EQ(player["libraries"][""], "AnimationLibrary_1");
  const json library = read.find("sub_resource", "id", "AnimationLibrary_1").properties;
  EXPECT_EQ(library["_data"]["wa_lk"], "Animation_1");
  EXPECT_EQ(read.find("sub_resource", "id", "Animation_1").attributes["type"], "Animation");
}

TEST(Godot, PicturesLieFromTheTopInTheirPixels) {
  const BakedAnimation animation = test::grid_that_bends(true);
  const GodotSceneReader read(godot_scene(animation, test::one_piece(animation), "walk"));
  const json node = read.find("node", "type", "Polygon2D").properties;
  const auto at = 2 * node["polygons"][0][0].get<std::size_t>();
  EXPECT_DOUBLE_EQ(node["uv"][at].get<double>(), 0.6) << "(0, 0) in [-1, 4] × [0, 5]: 3 × 2 pixels";
  EXPECT_DOUBLE_EQ(node["uv"][at + 1].get<double>(), 2);
  EXPECT_EQ(node["internal_vertex_count"], 4) << "the last of the 4 × 4 are inside";
  EXPECT_EQ(node["texture"], "1");
  EXPECT_EQ(read.find("ext_resource", "id", "1").attributes["path"], "walk.png");
}

TEST(Godot, EachPieceHasANodeAndATrack) {
  const BakedAnimation animation = test::grid_that_bends(true);
  std::vector<GltfPiece> pieces = test::one_piece(animation);
  pieces.push_back(pieces[0]);
  pieces[0].triangles.resize(4);
  pieces[1].triangles = {8, 9};
  const GodotSceneReader read(godot_scene(animation, pieces, "walk"));
  EXPECT_EQ(read.find("node", "name", "Piece2").properties["polygons"].size(), 2U);
  EXPECT_EQ(read.find("ext_resource", "id", "2").attributes["path"], "walk-2.png");
  const json track = read.find("sub_resource", "type", "Animation").properties;
  EXPECT_EQ(track["tracks/1/path"], "Piece2:polygon");
  EXPECT_EQ(track["tracks/1/keys"]["values"][0],
            read.find("node", "name", "Piece2").properties["polygon"]);
}

TEST(Godot, OneFrameRests) {
  BakedAnimation animation = test::grid_that_bends(false);
  animation.frames.resize(1);
  const GodotSceneReader read(godot_scene(animation, test::one_piece(animation), "walk"));
  EXPECT_DOUBLE_EQ(
      read.find("sub_resource", "type", "Animation").properties["length"].get<double>(), 0.1);
}

}  // namespace
}  // namespace foldless
