// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that are not proved are not gone through in any file: the frame before them stays, and the
// next is jumped to.
#include "app/export/held_steps.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/export/baked_files.h"
#include "tests/app/export/bent_grid.h"
#include "tests/app/export/godot_scene_reader.h"

namespace foldless {
namespace {

using nlohmann::json;

/// A grid that bends, and turns by 180 degrees between the frames 1 and 2: its vertices would go
/// straight through each other.
BakedAnimation grid_that_jumps() {
  BakedAnimation animation = test::grid_that_bends(true);
  for (const std::size_t i : {2U, 3U}) animation.frames[i].deformed *= -1;
  return animation;
}

/// From frame 1 to frame 2, and from the last to the first.
const HeldSteps kHeld{1, 3};

BakedFiles files_as(const char* name) {
  const BakedAnimation animation = grid_that_jumps();
  const BakedLook look{test::one_piece(animation), {}};
  return baked_files(name, *find_animation_format(name), animation, look);
}

TEST(HeldSteps, AreThoseThatAreNotProved) {
  for (const char* name : {"a.glb", "a.spine.json", "a.tscn", "a.foldless"})
    EXPECT_EQ(held_steps(files_as(name).failures), kHeld) << name;
  EXPECT_EQ(jump_words(1), "1 moment jumps");
  EXPECT_EQ(jump_words(2), "2 moments jump");
}

TEST(HeldSteps, InSpineAreStepped) {
  const json document = json::parse(files_as("a.spine.json").main);
  const json& slots = (*document["animations"].begin())["attachments"]["default"];
  const json& keys = (*slots.begin()->begin())["deform"];
  ASSERT_EQ(keys.size(), 5U);
  for (std::size_t k = 0; k < keys.size(); ++k)
    EXPECT_EQ(keys[k].value("curve", ""), kHeld.contains(k) ? "stepped" : "") << k;
}

TEST(HeldSteps, InGodotHaveATransitionOfNothing) {
  const test::GodotSceneReader scene(files_as("a.tscn").main);
  const json& animation = scene.find("sub_resource", "type", "Animation").properties;
  EXPECT_EQ(animation["tracks/0/keys"]["transitions"], json::parse("[1, 0, 1, 0, 1]"));
}

TEST(HeldSteps, InFoldlessAreListed) {
  const std::string text = files_as("a.foldless").main;
  const json header = json::parse(text.substr(0, text.find('\n')));
  EXPECT_EQ(header["held"], json::parse("[1, 3]"));
  EXPECT_EQ(header["proved"], false);
}

/// The numbers of an accessor.
std::vector<float> floats_of(const std::string& file, const json& document, int number) {
  const json& view =
      document["bufferViews"][document["accessors"][number]["bufferView"].get<int>()];
  const std::size_t start = file.find("BIN\0", 0, 4) + 4 + view["byteOffset"].get<std::size_t>();
  std::vector<float> values(view["byteLength"].get<std::size_t>() / 4);
  std::memcpy(values.data(), file.data() + start, 4 * values.size());
  return values;
}

TEST(HeldSteps, InGltfHaveTheirKeyOnceMoreJustBeforeTheNext) {
  const std::string file = files_as("a.glb").main;
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, 4);
  const json document = json::parse(file.substr(20, length));
  const json& sampler = document["animations"][0]["samplers"][0];
  const std::vector<float> times = floats_of(file, document, sampler["input"]);
  const std::vector<float> weights = floats_of(file, document, sampler["output"]);
  // Frames 0, 1, 1.5 and 3 of 4, ten a second.
  const float third = 0.15F, end = 0.4F;
  EXPECT_EQ(times, (std::vector{0.0F, 0.1F, std::nextafter(third, 0.0F), third, 0.3F,
                                std::nextafter(end, 0.0F), end}));
  ASSERT_EQ(weights.size(), 3 * times.size());
  const std::array frames{0, 1, 1, 2, 3, 3, 0};
  for (std::size_t k = 0; k < times.size(); ++k)
    for (int target = 1; target <= 3; ++target)
      EXPECT_EQ(weights[3 * k + static_cast<std::size_t>(target) - 1], frames[k] == target ? 1 : 0);
}

}  // namespace
}  // namespace foldless
