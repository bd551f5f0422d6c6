// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "tests/core/scene/scene_fixture.h"

namespace foldless {
namespace {

using test::SceneFolder;

constexpr std::string_view kMesh =
    R"("energy": "arap", "mesh": {"vertices": [[0, 0], [1, 0], [0, 1], [0, 0], [1, 0], [0, 1]],
       "triangles": [[0, 1, 2], [3, 4, 5]]})";

std::string with_parts(const std::string& parts) {
  return "{" + std::string(kMesh) + ",\n\"parts\": " + parts + "}";
}

TEST(SceneParts, AreKept) {
  const SceneFolder folder;
  const Scene scene = folder
                          .load(with_parts(R"([{"layer": "Körper", "vertex": 0, "vertices": 3},
                                 {"layer": "Arm", "vertex": 3, "vertices": 3, "depth": 1.5}])"))
                          .scene;
  ASSERT_NE(scene.parts, nullptr);
  EXPECT_EQ(*scene.parts, (MeshParts{{"Körper", 0, 3, 0}, {"Arm", 3, 3, 1.5}}));
  const std::string text = scene_text(scene, scene.folder);
  const Scene again = folder.load(text).scene;
  EXPECT_EQ(*again.parts, *scene.parts);
  EXPECT_EQ(scene_text(again, again.folder), text);
}

TEST(SceneParts, ThatDoNotFitAreRefused) {
  const SceneFolder folder;
  const auto refusal = [&](const std::string& parts) { return folder.error_in(with_parts(parts)); };
  EXPECT_NE(refusal(R"([{"layer": "A", "vertex": 1, "vertices": 5}])")
                .find("parts[0].vertex is 1, but the next part begins at 0"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"layer": "A", "vertex": 0, "vertices": 7}])")
                .find("parts[0].vertices is 7, but 3 to 6 are possible"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"layer": "A", "vertex": 0, "vertices": 3}])")
                .find("parts have 3 vertices, but the mesh has 6"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"vertex": 0, "vertices": 6}])").find("no key 'layer'"), std::string::npos);
  EXPECT_NE(refusal(R"([{"layer": "A", "vertex": 0, "vertices": 6, "depth": "top"}])")
                .find("a number is needed"),
            std::string::npos);
  const std::string split =
      R"({"energy": "arap", "mesh": {"vertices": [[0, 0], [1, 0], [1, 1], [0, 1], [5, 5], [6, 6]],
          "triangles": [[0, 1, 2], [0, 2, 3]]},
          "parts": [{"layer": "A", "vertex": 0, "vertices": 3},
                    {"layer": "B", "vertex": 3, "vertices": 3}]})";
  EXPECT_NE(folder.error_in(split).find("parts are not apart: a triangle lies in 'A'"),
            std::string::npos);
}

}  // namespace
}  // namespace foldless
