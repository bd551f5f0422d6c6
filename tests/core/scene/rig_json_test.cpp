// SPDX-License-Identifier: GPL-3.0-or-later
// Bones, mirror and stiff handles of scene files.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_fixture.h"

namespace foldless {
namespace {

using test::SceneFolder;

constexpr std::string_view kHandles =
    R"("handles": [{"vertex": 0, "target": [0, 0], "id": 7}, {"vertex": 1, "target": [1, 0]},)"
    R"( {"vertex": 2, "target": [1, 1]}])";

class RigJson : public testing::Test {
 protected:
  std::string error(std::string_view more) const {
    std::string keys(kHandles);
    keys.append(", ").append(more);
    return folder_.error_with(keys);
  }
  Scene scene(std::string_view more) const {
    std::string text = R"({"mesh": "square.obj", "energy": "arap", )";
    text.append(kHandles).append(more).append("}");
    return folder_.load(text).scene;
  }
  std::string error_of_stiff(std::string_view stiff) const {
    std::string keys = R"("handles": [{"vertex": 0, "target": [0, 0], "stiff": )";
    keys.append(stiff).append("}]");
    return folder_.error_with(keys);
  }

  SceneFolder folder_;
};

TEST_F(RigJson, NamesHandlesByTheirIds) {
  EXPECT_EQ(scene(R"(, "bones": [[2, 7, 1]])").rig.bones, std::vector<Bones>({{2, 7, 1}}));
  EXPECT_TRUE(scene(R"(, "bones": [])").rig.bones.empty());
  EXPECT_TRUE(scene("").rig.bones.empty());
}

TEST_F(RigJson, RefusesBonesThatCannotBe) {
  EXPECT_EQ(error(R"("bones": 3)"), "scene.json:2: bones is 3, but an array is needed");
  EXPECT_EQ(error(R"("bones": [7, 1])"), "scene.json:2: bones[0] is 7, but an array is needed");
  EXPECT_EQ(error(R"("bones": [[7]])"),
            "scene.json:2: bones[0] is an array of length 1, but the ids of two handles or more "
            "are needed");
  EXPECT_EQ(error(R"("bones": [[7, 0]])"),
            "scene.json:2: bones[0][1] is 0, but no handle has that id");
  EXPECT_EQ(error(R"("bones": [[7, "arm"]])"),
            "scene.json:2: bones[0][1] is 'arm', but an integer is needed");
  EXPECT_EQ(error(R"("bones": [[7, 1, 7]])"),
            "scene.json:2: bones[0][2] is 7, a handle that is a joint already");
  EXPECT_EQ(error(R"("bones": [[7, 1], [1, 2]])"),
            "scene.json:2: bones[1][0] is 1, a handle that is a joint already");
  EXPECT_EQ(folder_.error_with(R"("bones": [[0, 1]])"),
            "scene.json:2: bones[0][0] is 0, but no handle has that id");
}

TEST_F(RigJson, ReadsAMirror) {
  const Scene read = scene(R"(, "mirror": {"from": [0.5, 0], "to": [0.5, 1]})");
  ASSERT_TRUE(read.rig.mirror);
  EXPECT_EQ(*read.rig.mirror, (Mirror{{{0.5, 0}, {0.5, 1}}, true}));
  EXPECT_FALSE(
      scene(R"(, "mirror": {"from": [0, 0], "to": [1, 1], "on": false})").rig.mirror->is_on);
  EXPECT_FALSE(scene("").rig.mirror);
}

TEST_F(RigJson, RefusesAMirrorWithoutAnAxis) {
  EXPECT_EQ(error(R"("mirror": {"from": [1, 2], "to": [1, 2]})"),
            "scene.json:2: mirror.to is no other point than 'from', but an axis needs two");
  EXPECT_EQ(error(R"("mirror": {"from": [1, 2]})"),
            "scene.json:2: mirror has no key 'to', which is needed");
  EXPECT_EQ(error(R"("mirror": {"from": [1, 2], "to": [3, 4], "on": 1})"),
            "scene.json:2: mirror.on is 1, but true or false is needed");
  EXPECT_EQ(error(R"("mirror": {"from": [1, 2], "to": [3, 4], "angle": 1})"),
            "scene.json:2: mirror.'angle' = 1 is an unknown key; known keys are from, to, on");
}

TEST_F(RigJson, RefusesHandlesThatAreStiffInNoWay) {
  EXPECT_EQ(error_of_stiff("100"),
            "scene.json:2: handles[0].stiff is 100, but an object is needed");
  EXPECT_EQ(error_of_stiff(R"({"factor": 10})"),
            "scene.json:2: handles[0].stiff has no key 'radius', which is needed");
  EXPECT_EQ(error_of_stiff(R"({"factor": 0, "radius": 1})"),
            "scene.json:2: handles[0].stiff.factor is 0, but a number from 0.001 to 1000000 is "
            "needed");
  EXPECT_EQ(error_of_stiff(R"({"factor": 5, "radius": -1})"),
            "scene.json:2: handles[0].stiff.radius is -1, but a number greater than 0 is needed");
}

TEST_F(RigJson, AStiffHandleMakesTheMeshStiffRoundIt) {
  Scene read = scene("");
  EXPECT_FALSE(mesh_of(read).stiffness());
  read.handles[2].stiff = StiffDisk{50, 0.5};
  const auto stiffness = mesh_of(read).stiffness();
  ASSERT_TRUE(stiffness);
  EXPECT_EQ(stiffness->at({0.8, 0.8}), 50) << "the handle is at (1, 1)";
  EXPECT_EQ(stiffness->at({0.2, 0.2}), 1);
}

}  // namespace
}  // namespace foldless
