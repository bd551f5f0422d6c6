// SPDX-License-Identifier: GPL-3.0-or-later
// The animation of scene files.
#include <gtest/gtest.h>

#include "tests/core/scene/scene_fixture.h"

namespace foldless {
namespace {

constexpr std::string_view kPins =
    R"("handles": [{"vertex": 0, "target": [0, 0], "id": 7}, {"vertex": 1, "target": [1, 0],)"
    R"( "angle": 0, "radius": 0.2}, {"vertex": 2, "target": [1, 1]}])";

constexpr std::string_view kWhole =
    R"({"fps": 30, "frames": 12, "loop": true, "tracks": [)"
    R"({"handle": 7, "path": "smooth", "position": [{"frame": 0, "value": [0, 0], "easing": "both"},)"
    R"( {"frame": 12, "value": [2, 1], "easing": [0.1, -2, 0.9, 3]}], "depth": [{"frame": 3,)"
    R"( "value": 1.5, "easing": "hold"}]}, {"handle": 1, "angle": [{"frame": 0, "value": 0},)"
    R"( {"frame": 12, "value": 360}], "weight": [{"frame": 2, "value": 2}]}],)"
    R"( "groups": [{"center": [0.5, 0.25], "handles": [7, 2]}]})";

class AnimationJson : public testing::Test {
 protected:
  std::string error(const std::string& animation) const {
    std::string keys(kPins);
    keys.append(", \"animation\": ").append(animation);
    return folder_.error_with(keys);
  }
  /// What is wrong with a track of handle 7 in an animation of 12 frames.
  std::string error_of_track(const std::string& track, const std::string& handle = "7") const {
    std::string animation = R"({"frames": 12, "tracks": [{"handle": )";
    animation.append(handle).append(", ").append(track).append("}]}");
    const std::string text = error(animation);
    const std::string start = "scene.json:2: animation.tracks[0].";
    return text.starts_with(start) ? text.substr(start.size()) : text;
  }
  std::string error_of_key(const std::string& key) const {
    std::string track = R"("position": [)";
    track.append(key).append("]");
    const std::string text = error_of_track(track);
    const std::string start = "position[";
    return text.starts_with(start) ? text.substr(start.size()) : text;
  }
  Scene scene(const std::string& animation) const {
    std::string text = R"({"mesh": "square.obj", )";
    text.append(kPins).append(", \"animation\": ").append(animation).append("}");
    return folder_.load(text).scene;
  }

  test::SceneFolder folder_;
};

TEST_F(AnimationJson, ReadsTracksAndGroups) {
  const Scene read = scene(std::string(kWhole));
  ASSERT_TRUE(read.animation);
  Animation expected;
  expected.fps = 30;
  expected.cycle = {12, true};
  expected.tracks.resize(2);
  expected.tracks[0].handle = 7;
  expected.tracks[0].is_smooth = true;
  expected.tracks[0].position = {{0, {0, 0}, *find_easing("both")},
                                 {12, {2, 1}, {{0.1, -2}, {0.9, 3}}}};
  expected.tracks[0].depth = {{3, 1.5, *find_easing("hold")}};
  expected.tracks[1].handle = 1;
  expected.tracks[1].angle = {{0, 0, {}}, {12, 360, {}}};
  expected.tracks[1].weight = {{2, 2, {}}};
  expected.groups = {{{0.5, 0.25}, {7, 2}}};
  EXPECT_EQ(*read.animation, expected);
}

TEST_F(AnimationJson, IsWrittenAsItWasRead) {
  const Scene read = scene(std::string(kWhole));
  const std::string text = scene_text(read, read.folder);
  const Scene again = folder_.load(text).scene;
  ASSERT_TRUE(again.animation);
  EXPECT_EQ(*again.animation, *read.animation);
}

TEST_F(AnimationJson, NeedsItsFramesAlone) {
  const Scene read = scene(R"({"frames": 5})");
  ASSERT_TRUE(read.animation);
  EXPECT_EQ(read.animation->fps, 24);
  EXPECT_EQ(read.animation->cycle, (Cycle{5, false}));
  EXPECT_EQ(error("{}"), "scene.json:2: animation has no key 'frames', which is needed");
  EXPECT_EQ(error(R"({"frames": 0})"),
            "scene.json:2: animation.frames is 0, but a number from 1 to 100000 is needed");
  EXPECT_EQ(error(R"({"frames": 5, "fps": 1e9})"),
            "scene.json:2: animation.fps is 1e+09, but a number from 0.1 to 1000 is needed");
  EXPECT_EQ(error(R"({"frames": 5, "fps": 0.01})"),
            "scene.json:2: animation.fps is 0.01, but a number from 0.1 to 1000 is needed");
  EXPECT_EQ(error(R"({"frames": 5, "length": 2})"),
            "scene.json:2: animation.'length' = 2 is an unknown key; known keys are fps, frames, "
            "loop, tracks, groups");
}

TEST_F(AnimationJson, RefusesKeysOutOfOrderOrOutOfTheCycle) {
  EXPECT_EQ(error_of_key(R"({"frame": 12, "value": [0, 0]})"),
            "0].frame is 12, but the frames are 0 to 11");
  EXPECT_EQ(error_of_key(R"({"frame": -1, "value": [0, 0]})"),
            "0].frame is -1, but the frames are 0 to 11");
  EXPECT_EQ(error_of_key(R"({"frame": 1.5, "value": [0, 0]})"),
            "0].frame is 1.5, but an integer is needed");
  EXPECT_EQ(error_of_key(R"({"frame": 3, "value": [0, 0]}, {"frame": 3, "value": [1, 0]})"),
            "1].frame is 3, but the key before is at frame 3");
  EXPECT_EQ(error_of_key(R"({"frame": 3, "value": 5})"),
            "0].value is 5, but a point [x, y] is needed");
}

TEST_F(AnimationJson, RefusesEasingsThatRunBackInTime) {
  EXPECT_EQ(error_of_key(R"({"frame": 3, "value": [0, 0], "easing": "bounce"})"),
            "0].easing is 'bounce', which is unknown; known are linear, hold, in, out, both and "
            "[x1, y1, x2, y2]");
  EXPECT_EQ(error_of_key(R"({"frame": 3, "value": [0, 0], "easing": [0, 0, 1.5, 1]})"),
            "0].easing[2] is 1.5, but x goes from 0 to 1");
  EXPECT_EQ(error_of_key(R"({"frame": 3, "value": [0, 0], "easing": [0, 0, 1]})"),
            "0].easing is an array of length 3, but a name or [x1, y1, x2, y2] is needed");
}

TEST_F(AnimationJson, RefusesTracksOfHandlesThatCannotMoveSo) {
  EXPECT_EQ(error_of_track(R"("depth": [])", "99"), "handle is 99, but no handle has that id");
  EXPECT_EQ(error_of_track(R"("angle": [])"),
            "angle moves a handle that has no 'angle' and 'radius' and so does not turn");
  EXPECT_EQ(error_of_track(R"("weight": [{"frame": 0, "value": 0}])"),
            "weight[0].value is 0, but a number greater than 0 is needed");
  EXPECT_EQ(error_of_track(R"("path": "round")"),
            "path is 'round', but straight or smooth is needed");
  EXPECT_EQ(error(R"({"frames": 5, "tracks": [{"handle": 7}, {"handle": 7}]})"),
            "scene.json:2: animation.tracks[1].handle is 7, a handle that was named before");
  EXPECT_EQ(error(R"({"frames": 5, "groups": [{"center": [0, 0], "handles": [7, 7]}]})"),
            "scene.json:2: animation.groups[0].handles[1] is 7, a handle that was named before");
}

}  // namespace
}  // namespace foldless
