// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/core/scene/scene_fixture.h"

namespace foldless {
namespace {

using test::SceneFolder;

TEST(SceneMessages, NameUnknownWords) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_in("{\"mesh\": \"square.obj\",\n\"energy\": \"arpa\"}"),
            "scene.json:2: energy is 'arpa', which is unknown; known are dirichlet, lscm, arap, "
            "green-strain, symmetric-dirichlet");
  EXPECT_EQ(folder.error_with(R"("solver": {"method": "magic"})"),
            "scene.json:2: solver.method is 'magic', which is unknown; known are paper-flip, "
            "paper-noflip");
  EXPECT_EQ(folder.error_with(R"("solver": {"start": "later"})"),
            "scene.json:2: solver.start is 'later', which is unknown; known are rest, "
            "unconstrained, continuation");
  EXPECT_EQ(folder.error_with(R"("solver": {"distortion_bound": 1})"),
            "scene.json:2: solver.distortion_bound is 1, but must be a number greater than 1");
  EXPECT_EQ(
      folder.error_with(R"("colour": "red")"),
      "scene.json:2: 'colour' = 'red' is an unknown key; known keys are version, description, "
      "mesh, texture, texture_box, parts, energy, stiffness, handles, bones, mirror, "
      "animation, solver, state");
  EXPECT_TRUE(folder.error_with(R"("solver": {"detla": 1e-5})")
                  .starts_with("scene.json:2: solver.'detla' = 1e-05 is an unknown key"));
  EXPECT_TRUE(folder.error_with(R"("handles": [{"vertex": 0, "target": [0, 0], "x": 1}])")
                  .starts_with("scene.json:2: handles[0].'x' = 1 is an unknown key"));
}

TEST(SceneMessages, NameMissingKeys) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_in("{}"), "scene.json:1: the scene has no key 'mesh', which is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"target": [0, 0]}])"),
            "scene.json:2: handles[0] has no key 'vertex', which is needed");
}

TEST(SceneMessages, NameValuesOfTheWrongKind) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_in("[]"),
            "scene.json:1: the scene is an array of length 0, but an object is needed");
  EXPECT_EQ(folder.error_in(R"({"energy": 3})"), "scene.json:1: energy is 3, but a text is needed");
  EXPECT_EQ(
      folder.error_in(R"({"energy": "arap", "mesh": null})"),
      "scene.json:1: mesh is null, but a path or an object of vertices and triangles is needed");
  EXPECT_EQ(folder.error_with(R"("texture_box": [[0, 0], [0, 5]])"),
            "scene.json:2: texture_box is an array of length 2, but the lower left and the upper "
            "right corner are needed: [[x, y], [x, y]]");
  EXPECT_EQ(folder.error_with(R"("handles": {})"),
            "scene.json:2: handles is an object, but an array is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1.5, "target": [0, 0]}])"),
            "scene.json:2: handles[0].vertex is 1.5, but an integer is needed");
  EXPECT_EQ(
      folder.error_with(R"("handles": [{"vertex": 1, "target": [0]}])"),
      "scene.json:2: handles[0].target is an array of length 1, but a point [x, y] is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, "a"]}])"),
            "scene.json:2: handles[0].target[1] is 'a', but a number is needed");
  EXPECT_EQ(folder.error_with(R"("solver": {"condition_test": 1})"),
            "scene.json:2: solver.condition_test is 1, but true or false is needed");
}

TEST(SceneMessages, NameHandlesThatCannotBe) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 5, "target": [0, 0]}])"),
            "scene.json:2: handles[0].vertex is 5, but the vertices are 0 to 4");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": -1, "target": [0, 0]}])"),
            "scene.json:2: handles[0].vertex is -1, but the vertices are 0 to 4");
  EXPECT_EQ(folder.error_with("\"handles\": [{\"vertex\": 1, \"target\": [0, 0]},\n"
                              "{\"vertex\": 1, \"target\": [1, 0]}]"),
            "scene.json:3: handles[1].vertex is 1, which an earlier handle names already");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 4, "target": [0, 0]}])"),
            "scene.json:2: handles[0].vertex is 4, a vertex that belongs to no triangle");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "kind": "firm"}])"),
            "scene.json:2: handles[0].kind is 'firm', but drag, pin or soft is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "weight": 0}])"),
            "scene.json:2: handles[0].weight is 0, but a number greater than 0 is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "depth": "front"}])"),
            "scene.json:2: handles[0].depth is 'front', but a number is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "angle": 90}])"),
            "scene.json:2: handles[0] has no key 'radius', which is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "radius": 1}])"),
            "scene.json:2: handles[0] has no key 'angle', which is needed");
  EXPECT_EQ(
      folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "angle": 9, "radius": 0}])"),
      "scene.json:2: handles[0].radius is 0, but a number greater than 0 is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "name": 3}])"),
            "scene.json:2: handles[0].name is 3, but a text is needed");
  EXPECT_EQ(folder.error_with(R"("handles": [{"vertex": 1, "target": [0, 0], "id": 7},)"
                              R"({"vertex": 2, "target": [0, 0], "id": 7}])"),
            "scene.json:2: handles[1].id is 7, which an earlier handle has already");
}

TEST(SceneMessages, NameParametersOutOfRange) {
  const SceneFolder folder;
  const auto error = [&](const std::string& pair) {
    return folder.error_with("\"solver\": {" + pair + "}");
  };
  const std::string delta = "but must be a number greater than 0 and less than 1";
  EXPECT_EQ(error("\"delta\": 0"), "scene.json:2: solver.delta is 0, " + delta);
  EXPECT_EQ(error("\"delta\": 1"), "scene.json:2: solver.delta is 1, " + delta);
  EXPECT_EQ(error("\"delta\": -1e-5"), "scene.json:2: solver.delta is -1e-05, " + delta);
  EXPECT_EQ(error("\"alpha\": 0"),
            "scene.json:2: solver.alpha is 0, but must be a number greater than 0");
  EXPECT_EQ(error("\"beta\": -1"),
            "scene.json:2: solver.beta is -1, but must be a number of at least 0");
  EXPECT_EQ(error("\"inner_iterations\": 0"),
            "scene.json:2: solver.inner_iterations is 0, but must be an integer of at least 1 and "
            "at most 2147483647");
  EXPECT_NE(error("\"outer_iterations\": 2.5"), "");
  EXPECT_NE(error("\"outer_iterations\": 1e10"), "");
  EXPECT_NE(error("\"eta\": -0.1"), "");
}

TEST(SceneMessages, NameNumbersThatAreNotFinite) {
  const SceneFolder folder;
  EXPECT_TRUE(folder.error_with(R"("handles": [{"vertex": 1, "target": [1e999, 0]}])")
                  .starts_with("scene.json:2: not JSON: number overflow parsing '1e999'"));
  const std::string error = folder.error_with(R"("handles": [{"vertex": 1, "target": [0, NaN]}])");
  EXPECT_TRUE(error.starts_with("scene.json:2: not JSON: ")) << error;
  EXPECT_TRUE(error.ends_with(", in handles[0].target[1]")) << error;
}

TEST(SceneMessages, TellMeshesAndPicturesFromScenes) {
  const SceneFolder folder;
  const auto error = [&](const std::string& name, const std::string& bytes) {
    return test::error_of([&] { load_scene(folder.folder().write(name, bytes), {}); });
  };
  EXPECT_TRUE(error("a.obj", "v 0 0\n").ends_with("a.obj: is a mesh, but a scene is needed"));
  EXPECT_TRUE(error("a.png", "\x89PNG\r\n\x1a\n")
                  .ends_with("a.png: is no text, but a scene (JSON) is needed"));
}

TEST(SceneMessages, NameBothVersions) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_in("{\"version\": 2, \"novelty\": 1}"),
            "scene.json:1: version is 2, but this program reads version 1; use a newer Foldless");
  EXPECT_EQ(folder.error_in("{\"version\": 0}"),
            "scene.json:1: version is 0, but versions begin with 1");
}

TEST(SceneMessages, NameTheMeshFile) {
  const SceneFolder folder;
  EXPECT_EQ(folder.error_in(R"({"mesh": "gone.obj", "energy": "arap"})"),
            "scene.json:1: mesh is 'gone.obj', but there is no file gone.obj");
  EXPECT_TRUE(folder.error_in(R"({"mesh": "square.obj\u0000", "energy": "arap"})")
                  .ends_with("with a character 0, which no name of a file can have"));
  folder.folder().write("bad.obj", "v 0 0\nv 1 0\nv x 1\nf 1 2 3\n");
  EXPECT_TRUE(folder.error_in(R"({"mesh": "bad.obj", "energy": "arap"})")
                  .starts_with("bad.obj:3: vertex 3 has the coordinate 'x'"));
  EXPECT_EQ(folder.error_in(R"({"mesh": "", "energy": "arap"})"),
            "scene.json:1: mesh is '', but the path of a file is needed");
}

TEST(SceneMessages, NameWhatIsWrongWithAnInlineMesh) {
  const SceneFolder folder;
  const auto error = [&](const std::string& mesh) {
    return folder.error_in("{\"energy\": \"arap\", \"mesh\": {" + mesh + "}}");
  };
  EXPECT_EQ(error("\"vertices\": []"),
            "scene.json:1: mesh has no key 'triangles', which is needed");
  EXPECT_TRUE(error("\"vertices\": [[0,0],[1,0],[0,1]],\n\"triangles\": [[0,1,3]]")
                  .starts_with("scene.json:2: mesh: face 0 names vertex 3, but the vertices are 0 "
                               "to 2"));
  EXPECT_EQ(error("\"vertices\": [[0,0],[1,0],\n[0]], \"triangles\": []"),
            "scene.json:2: mesh.vertices[2] is an array of length 1, but a point [x, y] is needed");
  EXPECT_EQ(error("\"vertices\": [[0,0]], \"triangles\": [[0, 1]]"),
            "scene.json:1: mesh.triangles[0] is an array of length 2, but a triangle [a, b, c] is "
            "needed");
  EXPECT_EQ(error("\"vertices\": [[0,0]], \"triangles\": [[0, 1, 0.5]]"),
            "scene.json:1: mesh.triangles[0][2] is 0.5, but an integer is needed");
}

TEST(SceneMessages, NameWhatIsWrongWithTheState) {
  const SceneFolder folder;
  const std::string triangles = "\"triangles\": [[0,1,2],\n[0,2,3]]";
  const std::string rest = "\"rest\": [[0,0],[1,0],[1,1],[0,1],[9,9]]";
  const auto error = [&](const std::string& state) {
    return folder.error_with("\"state\": {" + state + "}");
  };
  EXPECT_EQ(error(triangles + ", " + rest),
            "scene.json:2: state has no key 'deformed', which is needed");
  EXPECT_EQ(error(triangles + ", " + rest + ", \"deformed\": [[0,0],[1,0],[1,1],[2,-1],[9,9]]"),
            "scene.json:3: state.deformed: face 1 (vertices 0 2 3) is clockwise (1 triangle in "
            "all); every triangle must be counter-clockwise");
  EXPECT_EQ(error(triangles + ", " + rest + ", \"deformed\": [[0,0],[1,0],[1,1],[0,1]]"),
            "scene.json:3: state.deformed has 4 vertices, but state.rest has 5");
  EXPECT_TRUE(error("\"triangles\": [[0,1,2]], \"rest\": [[0,0],[1,0],[0,1]], "
                    "\"deformed\": [[0,0],[1,0],[0,1]]")
                  .starts_with("scene.json:2: state.rest has 3 vertices, but the mesh has 5;"));
  EXPECT_TRUE(error("\"triangles\": [[0,1,7]], " + rest + ", \"deformed\": []")
                  .starts_with("scene.json:2: state.rest: face 0 names vertex 7"));
}

TEST(SceneMessages, NameWhatIsWrongWithStiffness) {
  const SceneFolder folder;
  const auto error = [&](const std::string& stroke) {
    return folder.error_with("\"stiffness\": [{" + stroke + "}]");
  };
  const std::string line = "\"line\": [[0, 0]], ";
  EXPECT_EQ(error("\"line\": [], \"radius\": 1, \"factor\": 2"),
            "scene.json:2: stiffness[0].line is empty, but points [[x, y], ...] are needed");
  EXPECT_EQ(error(line + "\"radius\": 0, \"factor\": 2"),
            "scene.json:2: stiffness[0].radius is 0, but a number greater than 0 is needed");
  EXPECT_EQ(
      error(line + "\"radius\": 1, \"factor\": -2"),
      "scene.json:2: stiffness[0].factor is -2, but a number from 0.001 to 1000000 is needed");
  EXPECT_EQ(error(line + "\"center\": [0, 0], \"radius\": 1, \"factor\": 2"),
            "scene.json:2: stiffness[0].line and 'center' exclude each other");
  EXPECT_EQ(error("\"radius\": 1, \"factor\": 2"),
            "scene.json:2: stiffness[0] has no key 'center', which is needed");
  EXPECT_EQ(error(line + "\"radius\": 1"),
            "scene.json:2: stiffness[0] has no key 'factor', which is needed");
  EXPECT_EQ(
      error(line + "\"radius\": 1, \"factor\": 2, \"colour\": 3"),
      "scene.json:2: stiffness[0].'colour' = 3 is an unknown key; known keys are center, line, "
      "radius, factor");
}

TEST(SceneMessages, NameAMissingScene) {
  const SceneFolder folder;
  const std::string error =
      test::error_of([&] { load_scene(folder / "gone.json", test::kMethodNames); });
  EXPECT_TRUE(error.starts_with((folder / "gone.json").string() + ": cannot be read")) << error;
}

}  // namespace
}  // namespace foldless
