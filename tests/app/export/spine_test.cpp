// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/spine.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/export/engine_mesh.h"
#include "tests/app/export/bent_grid.h"

namespace foldless {
namespace {

using nlohmann::json;

const EngineUnits kUnits{{1.5, 1.5}, 0.003};

/// A skeleton as the format's description says that it is read: in single precision.
class ReadSpine {
 public:
  explicit ReadSpine(const std::string& text) : document(json::parse(text)) {
    EXPECT_EQ(document["bones"], json::parse(R"([{"name":"root"}])"));
    EXPECT_EQ(document["skins"].size(), 1U);
    EXPECT_EQ(document["skins"][0]["name"], "default");
    EXPECT_EQ(document["skeleton"]["spine"].get<std::string>().substr(0, 2), "4.");
  }

  std::string slot(std::size_t number = 0) const {
    const json& slot = document["slots"].at(number);
    EXPECT_EQ(slot["bone"], "root");
    EXPECT_EQ(slot["attachment"], slot["name"]);
    return slot["name"];
  }
  const json& mesh(std::size_t number = 0) const {
    const json& attachment = document["skins"][0]["attachments"][slot(number)][slot(number)];
    EXPECT_EQ(attachment["type"], "mesh");
    EXPECT_EQ(attachment["uvs"].size(), attachment["vertices"].size()) << "no weights";
    return attachment;
  }
  const json& keys(std::size_t number = 0) const {
    const json& animation = *document["animations"].begin();
    return animation["attachments"]["default"][slot(number)][slot(number)]["deform"];
  }

  /// What of a key is left out is 0.
  std::vector<float> at_key(std::size_t key) const {
    std::vector<float> places = mesh()["vertices"];
    const json& read = keys().at(key);
    const std::size_t offset = read.value("offset", 0);
    const json by = read.value("vertices", json::array());
    for (std::size_t i = 0; i < by.size(); ++i) places.at(offset + i) += by[i].get<float>();
    return places;
  }
  std::vector<float> at(float time) const {
    std::size_t key = 0;
    while (key + 2 < keys().size() && keys()[key + 1].value("time", 0.0F) <= time) ++key;
    EXPECT_FALSE(keys()[key].contains("curve")) << "linear";
    const float start = keys()[key].value("time", 0.0F), end = keys()[key + 1].value("time", 0.0F);
    const std::vector<float> from = at_key(key), to = at_key(key + 1);
    std::vector<float> places;
    for (std::size_t i = 0; i < from.size(); ++i)
      places.push_back(from[i] + (to[i] - from[i]) * (time - start) / (end - start));
    return places;
  }

  json document;
};

/// The largest distance between what a file has of triangles' corners and what an animation has.
double largest_distance(const ReadSpine& read, const std::vector<float>& places,
                        const BakedAnimation& animation, const Points& expected) {
  double largest = 0;
  const std::vector<int> corners = read.mesh()["triangles"];
  EXPECT_EQ(corners.size(), static_cast<std::size_t>(animation.triangles.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto at = 2 * static_cast<std::size_t>(corners[i]);
    const Vec2 seen(places.at(at), places.at(at + 1));
    const int v = animation.triangles.reshaped()[static_cast<Eigen::Index>(i)];
    largest = std::max(largest, (seen - expected.col(v)).norm());
  }
  return largest;
}

TEST(Spine, IsReplayedToTheSamePlaces) {
  for (const bool loops : {true, false}) {
    const BakedAnimation animation = test::grid_that_bends(loops);
    const BakedAnimation held = in_pixels(animation, kUnits);
    const ReadSpine read(spine_text(held, test::one_piece(animation), "walk").json);
    const auto frame = [&](std::size_t i) { return held.frames[i % 4].deformed; };
    ASSERT_EQ(read.keys().size(), loops ? 5U : 4U);
    for (std::size_t k = 0; k < read.keys().size(); ++k) {
      const std::vector<float> places = read.at_key(k);
      EXPECT_EQ(largest_distance(read, places, animation, frame(k)), 0) << k;
      const Points exact =
          (animation.frames[k % 4].deformed.colwise() - kUnits.origin) / kUnits.pixel;
      EXPECT_LT(largest_distance(read, places, animation, exact), 1e-6 * 1000) << k;
    }
    EXPECT_LT(largest_distance(read, read.at(0.125F), animation, 0.5 * (frame(1) + frame(2))),
              1e-3);
    if (!loops) continue;
    EXPECT_LT(largest_distance(read, read.at(0.35F), animation, 0.5 * (frame(3) + frame(0))), 1e-3);
  }
}

TEST(Spine, KeysAreAtTheTimesOfTheirFrames) {
  const BakedAnimation held = in_pixels(test::grid_that_bends(true), kUnits);
  const ReadSpine read(spine_text(held, test::one_piece(held), "walk").json);
  std::vector<double> times;
  for (const json& key : read.keys()) times.push_back(key.value("time", 0.0));
  EXPECT_EQ(times, (std::vector<double>{0, 0.1, 0.15, 0.3, 0.4}));
  EXPECT_FALSE(read.keys()[0].contains("vertices")) << "as in the setup pose";
  EXPECT_FALSE(read.keys()[4].contains("vertices")) << "the loop is closed";
}

TEST(Spine, KeysHoldWhatMovesAlone) {
  BakedAnimation animation = test::grid_that_bends(false);
  for (BakedFrame& frame : animation.frames) frame.deformed = animation.rest;
  animation.frames[2].deformed(1, 5) += 0.25;
  const BakedAnimation held = in_pixels(animation, kUnits);
  const ReadSpine read(spine_text(held, test::one_piece(animation), "walk").json);
  ASSERT_EQ(read.keys()[2]["vertices"].size(), 1U);
  const int offset = read.keys()[2]["offset"];
  EXPECT_EQ(offset % 2, 1) << "y";
  EXPECT_GT(read.keys()[2]["vertices"][0], 0) << "y is up";
  EXPECT_EQ(largest_distance(read, read.at_key(2), animation, held.frames[2].deformed), 0);
}

TEST(Spine, TheMeshHasItsHullFirstAndAllItsEdges) {
  const BakedAnimation held = in_pixels(test::grid_that_bends(true), kUnits);
  const ReadSpine read(spine_text(held, test::one_piece(held), "walk").json);
  const json& mesh = read.mesh();
  EXPECT_EQ(mesh["hull"], 12);
  EXPECT_EQ(mesh["width"], 3);
  EXPECT_EQ(mesh["height"], 2);
  ASSERT_EQ(mesh["edges"].size(), 2U * 33);
  std::set<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < mesh["edges"].size(); i += 2) {
    EXPECT_EQ(mesh["edges"][i].get<int>() % 2, 0) << "places among x and y";
    edges.insert({mesh["edges"][i].get<int>() / 2, mesh["edges"][i + 1].get<int>() / 2});
  }
  for (int i = 0; i + 1 < 12; ++i) EXPECT_TRUE(edges.contains({i, i + 1})) << i;
  EXPECT_TRUE(edges.contains({0, 11}));
}

TEST(Spine, PicturesLieFromTheTop) {
  const BakedAnimation animation = test::grid_that_bends(true);
  // Pieces as they are in pixels of one length.
  const ReadSpine read(spine_text(animation, test::one_piece(animation), "walk").json);
  const int corner = read.mesh()["triangles"][0];  // The vertex at (0, 0) in [-1, 4] × [0, 5].
  const auto at = 2 * static_cast<std::size_t>(corner);
  EXPECT_DOUBLE_EQ(read.mesh()["uvs"][at].get<double>(), 0.2);
  EXPECT_DOUBLE_EQ(read.mesh()["uvs"][at + 1].get<double>(), 1);
}

TEST(Spine, TheAtlasHasARegionForEachAttachment) {
  const BakedAnimation animation = test::grid_that_bends(true);
  std::vector<GltfPiece> pieces = test::one_piece(animation);
  EXPECT_EQ(spine_text(animation, pieces, "a b").atlas,
            "a b.png\nsize:3,2\nfilter:Linear,Linear\na b\nbounds:0,0,3,2\n");
  pieces.push_back(pieces[0]);
  pieces[0].triangles.resize(4);
  pieces[1].triangles = {8, 9};
  const SpineText text = spine_text(animation, pieces, "a");
  const ReadSpine read(text.json);
  EXPECT_EQ(read.slot(1), "a-2");
  EXPECT_EQ(read.mesh(1)["triangles"].size(), 6U);
  EXPECT_EQ(read.keys(1).size(), 5U);
  EXPECT_NE(text.atlas.find("\n\na-2.png\n"), std::string::npos) << "pages are parted";
  EXPECT_NE(text.atlas.find("\na-2\nbounds:"), std::string::npos);
}

}  // namespace
}  // namespace foldless
