// SPDX-License-Identifier: GPL-3.0-or-later
// Depths of handles in scene files, results and pictures.
#include <gtest/gtest.h>

#include "core/scene/scene_io.h"
#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/support/ribbon_scene.h"

namespace foldless::test {
namespace {

/// Writes a scene of a ribbon that crosses itself, its left end so deep.
void write_crossing(const std::string& file, double depth) {
  Scene scene = crossing_scene();
  scene.handles[0].depth = depth;
  save_scene(scene, file);
}

Image rendered(const TemporaryFolder& folder, const std::string& file) {
  const Ended ended = run({"render", folder / file, "-o", folder / "picture.png", "--size",
                           "200x200", "--layers", "fill,wire,boundary"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  return load_image(folder / "picture.png");
}

TEST(Depth, OfASceneAndOfAResultDecideWhatIsInFront) {
  const TemporaryFolder folder;
  write_crossing(folder / "front.json", 1);
  write_crossing(folder / "back.json", -1);
  write_crossing(folder / "none.json", 0);
  EXPECT_FALSE(rendered(folder, "front.json") == rendered(folder, "back.json"));
  EXPECT_EQ(rendered(folder, "none.json"), rendered(folder, "back.json"));
  for (const std::string name : {"front", "back"})
    EXPECT_EQ(run({"solve", folder / (name + ".json"), "-o", folder / name}).status, 0);
  EXPECT_FALSE(rendered(folder, "front") == rendered(folder, "back"));
}

}  // namespace
}  // namespace foldless::test
