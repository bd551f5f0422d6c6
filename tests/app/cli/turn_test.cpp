// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that turn the mesh round them, from the scene file to the proof.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/cli/command.h"
#include "tests/app/cli/solved.h"

namespace foldless {
namespace {

using test::grid_problem;
using test::TemporaryFolder;
using test::write_scene;

/// A grid of 9 × 9 vertices whose middle turns; the corner in the lower left is held.
Problem turned(double angle) {
  Problem problem = grid_problem(9, Vec2(8, 8));
  Handle hub;
  hub.id = 9;
  hub.vertex = 40;
  hub.target = problem.mesh.rest().col(40);
  hub.turn = Turn{angle, 1.5};
  hub.name = "hub";
  problem.handles.push_back(hub);
  return problem;
}

TEST(TurningScene, IsSolvedProvedAndReported) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", turned(80));
  const std::string out = folder / "out";
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", out}).status, 0);
  EXPECT_EQ(
      test::run({"check", out + "/rest.obj", out + "/deformed.obj", folder / "scene.json"}).status,
      0);
  const auto report = nlohmann::json::parse(test::read_text(out + "/report.json"));
  const auto& hub = report.at("handles").at(2);
  EXPECT_EQ(hub.at("angle"), 80);
  EXPECT_EQ(hub.at("radius"), 1.5);
  EXPECT_EQ(hub.at("name"), "hub");
}

TEST(TurningScene, IsNotSatisfiedWhereTheMeshDidNotTurn) {
  const TemporaryFolder folder;
  write_scene(folder / "still.json", turned(0));
  write_scene(folder / "turned.json", turned(80));
  const std::string out = folder / "out";
  ASSERT_EQ(test::run({"solve", folder / "still.json", "-o", out}).status, 0);
  const auto is_satisfied = [&](const std::string& scene) {
    const auto ended = test::run({"check", out + "/rest.obj", out + "/deformed.obj", scene});
    return nlohmann::json::parse(ended.out).at("satisfied").get<bool>();
  };
  EXPECT_TRUE(is_satisfied(folder / "still.json"));
  EXPECT_FALSE(is_satisfied(folder / "turned.json"));
}

}  // namespace
}  // namespace foldless
