// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/app/export/bent_grid.h"

namespace foldless {
namespace {

using nlohmann::json;

using test::grid_that_bends;
using test::one_piece;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// A file as a viewer reads it.
class ReadGltf {
 public:
  explicit ReadGltf(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(u32(file, 4), 2U);
    EXPECT_EQ(u32(file, 8), file.size());
    const std::size_t length = u32(file, 12);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    document = json::parse(file.substr(20, length));
    EXPECT_EQ(file.substr(20 + length + 4, 4), std::string("BIN\0", 4));
    bytes_ = file.substr(20 + length + 8);
    EXPECT_EQ(u32(file, 20 + length), bytes_.size());
    EXPECT_EQ(document["buffers"][0]["byteLength"], bytes_.size());
  }

  std::string view(int number) const {
    const json& view = document["bufferViews"].at(static_cast<std::size_t>(number));
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
    return bytes_.substr(view["byteOffset"], view["byteLength"]);
  }
  std::vector<float> floats(int number, int components) const {
    const json& accessor = document["accessors"].at(static_cast<std::size_t>(number));
    EXPECT_EQ(accessor["componentType"], 5126);
    const std::string data = view(accessor["bufferView"]);
    std::vector<float> values(data.size() / 4);
    std::memcpy(values.data(), data.data(), data.size());
    EXPECT_EQ(values.size(),
              accessor["count"].get<std::size_t>() * static_cast<std::size_t>(components));
    if (accessor.contains("min")) {
      for (int k = 0; k < components; ++k) {
        float least = values[static_cast<std::size_t>(k)], most = least;
        for (std::size_t i = static_cast<std::size_t>(k); i < values.size();
             i += static_cast<std::size_t>(components)) {
          least = std::min(least, values[i]);
          most = std::max(most, values[i]);
        }
        EXPECT_EQ(accessor["min"][static_cast<std::size_t>(k)].get<float>(), least);
        EXPECT_EQ(accessor["max"][static_cast<std::size_t>(k)].get<float>(), most);
      }
    }
    return values;
  }
  const json& primitive() const { return document["meshes"][0]["primitives"][0]; }

  /// The places of the vertices at a time, as the specification says: weights between keys by
  /// linear interpolation, then the first positions and the weighted differences.
  Points at(double time) const {
    const json& sampler = document["animations"][0]["samplers"][0];
    EXPECT_EQ(sampler["interpolation"], "LINEAR");
    const std::vector<float> times = floats(sampler["input"], 1);
    const std::vector<float> weights = floats(sampler["output"], 1);
    std::size_t key = 0;
    while (key + 2 < times.size() && times[key + 1] <= time) ++key;
    const double share = (time - times[key]) / (static_cast<double>(times[key + 1]) - times[key]);
    const std::vector<float> base = floats(primitive()["attributes"]["POSITION"], 3);
    std::vector<double> places(base.begin(), base.end());
    const std::size_t targets = primitive()["targets"].size();
    EXPECT_EQ(weights.size(), targets * times.size());
    for (std::size_t i = 0; i < targets; ++i) {
      const double weight =
          (1 - share) * weights[key * targets + i] + share * weights[(key + 1) * targets + i];
      const std::vector<float> by = floats(primitive()["targets"][i]["POSITION"], 3);
      for (std::size_t k = 0; k < places.size(); ++k) places[k] += weight * by[k];
    }
    Points points(2, static_cast<Eigen::Index>(places.size() / 3));
    for (Eigen::Index v = 0; v < points.cols(); ++v)
      points.col(v) = Vec2(places[static_cast<std::size_t>(3 * v)],
                           places[static_cast<std::size_t>(3 * v) + 1]);
    return points;
  }

  json document;

 private:
  std::string bytes_;
};

TEST(Gltf, IsPlayedStraightFromFrameToFrame) {
  const BakedAnimation animation = grid_that_bends(true);
  const ReadGltf read(gltf_binary(animation, one_piece(animation)));
  const auto frame = [&](std::size_t i) { return animation.frames[i].deformed; };
  const auto expect = [&](double time, const Points& expected) {
    EXPECT_LT((read.at(time) - expected).cwiseAbs().maxCoeff(), 1e-6 * 4) << time;
  };
  expect(0, frame(0));
  expect(0.1, frame(1));
  expect(0.15, frame(2));
  expect(0.125, 0.5 * (frame(1) + frame(2)));
  expect(0.3, frame(3));
  expect(0.35, 0.5 * (frame(3) + frame(0)));
  expect(0.4, frame(0));
}

TEST(Gltf, EndsWithItsLastFrameWhereItIsNoLoop) {
  const BakedAnimation animation = grid_that_bends(false);
  const ReadGltf read(gltf_binary(animation, one_piece(animation)));
  const json& input =
      read.document["accessors"]
                   [read.document["animations"][0]["samplers"][0]["input"].get<std::size_t>()];
  EXPECT_EQ(input["count"], 4);
  EXPECT_FLOAT_EQ(input["max"][0], 0.3F);
}

TEST(Gltf, SinglePrecisionIsWhatAViewerSees) {
  const BakedAnimation animation = grid_that_bends(true);
  const ReadGltf read(gltf_binary(animation, one_piece(animation)));
  const BakedAnimation seen = in_single_precision(animation);
  EXPECT_EQ(read.at(0), seen.frames[0].deformed);
  const json& targets = read.primitive()["targets"];
  const std::vector<float> base = read.floats(read.primitive()["attributes"]["POSITION"], 3);
  for (std::size_t i = 1; i < seen.frames.size(); ++i) {
    const std::vector<float> by = read.floats(targets[i - 1]["POSITION"], 3);
    for (Eigen::Index v = 0; v < seen.rest.cols(); ++v)
      for (Eigen::Index k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(3 * v + k);
        EXPECT_EQ(seen.frames[i].deformed(k, v), static_cast<double>(base[at]) + by[at]);
      }
  }
  EXPECT_NE(seen.frames[1].deformed, animation.frames[1].deformed);
}

TEST(Gltf, ShowsItsPicturesOnTheirTriangles) {
  const BakedAnimation animation = grid_that_bends(true);
  std::vector<GltfPiece> pieces = one_piece(animation);
  pieces.push_back(pieces[0]);
  pieces[0].triangles.resize(5);
  pieces[1].triangles = {7, 9};
  pieces[1].z = 0.25;
  const ReadGltf read(gltf_binary(animation, pieces));
  const json& primitives = read.document["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U);
  const json& indices = read.document["accessors"][primitives[1]["indices"].get<std::size_t>()];
  EXPECT_EQ(indices["count"], 6);
  const std::string bytes = read.view(indices["bufferView"]);
  EXPECT_EQ(u32(bytes, 8), static_cast<std::uint32_t>(animation.triangles(2, 7)));
  EXPECT_EQ(read.floats(primitives[1]["attributes"]["POSITION"], 3)[2], 0.25F);
  const std::vector<float> places = read.floats(primitives[0]["attributes"]["TEXCOORD_0"], 2);
  EXPECT_FLOAT_EQ(places[0], 0.2F) << "the first vertex is at (0, 0) in [-1, 4] × [0, 5]";
  EXPECT_FLOAT_EQ(places[1], 1) << "from the top";
  const json& image = read.document["images"][1];
  EXPECT_EQ(decode_image(read.view(image["bufferView"])), pieces[1].image);
}

TEST(Gltf, OneFrameIsAMeshThatRests) {
  BakedAnimation animation = grid_that_bends(false);
  animation.frames.resize(1);
  const ReadGltf read(gltf_binary(animation, one_piece(animation)));
  EXPECT_FALSE(read.document.contains("animations"));
  EXPECT_FALSE(read.primitive().contains("targets"));
}

}  // namespace
}  // namespace foldless
