// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "core/files/mesh_io.h"
#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"

namespace foldless {
namespace {

using test::Ended;
using test::grid_problem;
using test::names_in;
using test::TemporaryFolder;
using test::write_scene;
using test::write_text;

/// Status 2, nothing on stdout, and one line on stderr, which is returned.
std::string refusal(const std::vector<std::string>& arguments) {
  const Ended ended = test::run(arguments);
  EXPECT_EQ(ended.status, 2) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_TRUE(ended.err.starts_with("foldless: ")) << ended.err;
  EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  EXPECT_TRUE(ended.err.ends_with('\n'));
  return ended.err;
}

bool says(const std::string& message, const std::string& words) {
  return message.find(words) != std::string::npos;
}

TEST(BadInput, ScenesAreRefusedWithFileAndLineAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string mesh = R"("mesh": {"vertices": [[0,0],[1,0],[0,1]], "triangles": [[0,1,2]]})";
  const std::vector<std::pair<std::string, std::string>> scenes{
      {"", "scene.json"},
      {"{\n\"mesh\": ", "scene.json:"},
      {"{" + mesh + ", \"energy\": \"rubber\", \"handles\": []}", "rubber"},
      {"{" + mesh + ",\n\"energy\": \"arap\",\n\"colour\": 1}", "colour"},
      {"{" + mesh + ",\n\"energy\": \"arap\",\n\"handles\": [{\"vertex\": 3, \"target\": [0,0]}]}",
       "scene.json:3"},
      {"{" + mesh + ", \"energy\": \"arap\", \"solver\": {\"delta\": 1}}", "delta"},
      {"{" + mesh + ", \"energy\": \"arap\", \"solver\": {\"method\": \"magic\"}}", "magic"},
      {"{\"mesh\": \"none.obj\", \"energy\": \"arap\"}", "none.obj"},
      {"{" + mesh + ", \"energy\": \"arap\", \"version\": 99}", "99"},
  };
  std::set<std::string> messages;
  for (const auto& [text, words] : scenes) {
    write_text(folder / "scene.json", text);
    const std::string message =
        refusal({"solve", folder / "scene.json", "-o", folder / "out", "--frames", "all"});
    EXPECT_TRUE(says(message, words)) << message;
    messages.insert(message);
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"scene.json"});
  }
  EXPECT_EQ(messages.size(), scenes.size()) << "each has a message of its own";
}

TEST(BadInput, WhatCannotBeSolvedIsNamedToo) {
  const TemporaryFolder folder;
  // A triangle beside another is too small for any unit in which both can be solved.
  write_text(folder / "scene.json", R"({"energy": "arap",
    "mesh": {"vertices": [[0,0],[1e-251,0],[0,1e-251],[1e74,1e74]], "triangles": [[0,1,2],[1,3,2]]},
    "handles": [{"vertex": 0, "target": [0,0], "id": 1}, {"vertex": 3, "target": [2,1], "id": 2}],
    "animation": {"fps": 10, "frames": 2, "tracks": []}})");
  const std::string expected = "foldless: " + (folder / "scene.json") +
                               ": the mesh is too large or too small for double precision; "
                               "scale it\n";
  EXPECT_EQ(refusal({"solve", folder / "scene.json", "-o", folder / "out"}), expected);
  EXPECT_EQ(refusal({"animate", folder / "scene.json", "-o", folder / "a.gif"}), expected);
}

TEST(BadInput, OptionsAreRefusedByName) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  const std::string out = folder / "out";
  write_scene(scene, grid_problem(3, Vec2(2, 2)));
  const std::vector<std::vector<std::string>> calls{
      {"--method", "magic"}, {"--energy", "rubber"},
      {"--alpha", "much"},   {"--alpha", "-1"},
      {"--beta", "-0.5"},    {"--delta", "1"},
      {"--eta", "nan"},      {"--inner", "0"},
      {"--inner", "2.5"},    {"--outer", "1e99"},
      {"--frames", "0"},     {"--frames", "some"},
      {"--threads", "0"},    {"--fast"},
      {"--time-limit", "0"}, {"--time-limit", "soon"},
  };
  for (const auto& options : calls) {
    std::vector<std::string> arguments{"solve", scene, "-o", out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_TRUE(says(refusal(arguments), options[0])) << options[0];
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

TEST(BadInput, CallsThatLackSomethingAreRefused) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", grid_problem(3, Vec2(2, 2)));
  EXPECT_TRUE(says(refusal({"solve"}), "SCENE"));
  EXPECT_TRUE(says(refusal({"solve", folder / "scene.json"}), "--output"));
  EXPECT_TRUE(says(refusal({"render", folder / "scene.json"}), "--output"));
  EXPECT_TRUE(says(refusal({"check", "rest.obj"}), "DEFORMED"));
  EXPECT_TRUE(says(refusal({"one.json", "two.json"}), "two.json"));
}

TEST(BadInput, AFolderThatCannotBeMadeIsNamed) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", grid_problem(3, Vec2(2, 2)));
  write_text(folder / "file", "not a folder");
  const std::string message =
      refusal({"solve", folder / "scene.json", "-o", folder / "file/deeper"});
  EXPECT_TRUE(says(message, "file/deeper")) << message;
  EXPECT_EQ(test::read_text(folder / "file"), "not a folder");
}

TEST(BadInput, RenderRefusesAndLeavesNoPicture) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  write_scene(scene, grid_problem(3, Vec2(2, 2)));
  const std::string picture = folder / "picture.png";
  EXPECT_TRUE(says(refusal({"render", folder / "none.json", "-o", picture}), "none.json"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", folder / "picture.bmp"}), ".png, .svg or .pdf"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", folder / "ui.svg", "--ui"}), ".png"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--ui", "--view", "rest"}), "--view"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--layers", "glow"}), "glow"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--size", "big"}), "big"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--view", "top"}), "top"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--samples", "0"}), "--samples"));
  EXPECT_TRUE(says(refusal({"render", scene, "-o", picture, "--texture", scene}), "scene.json"));
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"scene.json"});
}

TEST(BadInput, MeshesOfDifferentTrianglesAreNoMap) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const test::Fixture& f) {
    write_mesh(folder / name, f.triangles, f.rest);
  };
  write("grid.obj", test::square_grid(3));
  write("hexagon.obj", test::hexagon());
  test::Fixture other = test::square_grid(3);
  other.triangles.col(0) << 0, 1, 3;
  other.triangles.col(1) << 1, 4, 3;
  write("other.obj", other);
  EXPECT_TRUE(says(refusal({"check", folder / "grid.obj", folder / "hexagon.obj"}), "7 vertices"));
  EXPECT_TRUE(says(refusal({"check", folder / "grid.obj", folder / "other.obj"}), "triangles"));
  EXPECT_TRUE(says(refusal({"check", folder / "grid.obj", folder / "none.obj"}), "none.obj"));
}

}  // namespace
}  // namespace foldless
