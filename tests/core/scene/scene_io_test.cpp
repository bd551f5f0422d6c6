// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_io.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "core/energy/densities.h"
#include "core/files/atomic_file.h"
#include "core/mesh/injective.h"
#include "tests/core/scene/scene_fixture.h"
#include "tests/support/mutation.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::SceneFolder;

constexpr std::string_view kPlain =
    R"({"mesh": "square.obj", "energy": "lscm", "handles": [{"vertex": 2, "target": [1.5, -0.25]}],
       "solver": {"delta": 1e-05, "eta": 0.01}})";

TEST(SceneIo, TakesArapWhereNoEnergyIsNamed) {
  const SceneFolder folder;
  EXPECT_EQ(folder.load(R"({"mesh": "square.obj"})").scene.energy, find_density("arap"));
}

/// Every key that a scene can have, the mesh inside.
Scene full_scene() {
  Scene scene;
  scene.rest.resize(2, 5);
  scene.rest << 0, 1.0 / 3, 1, 0, 0.1,  //
      0, -0.0, 1, 1e-17 + 1, 0.2;
  scene.triangles = Triangles::Map(std::array{0, 1, 2, 0, 2, 3}.data(), 3, 2);
  scene.texture_path = "pictures/a \"b\".png";
  scene.texture_box = TextureBox{{-0.25, 0}, {1, 1.5}};
  scene.energy = find_density("green-strain");
  const Points line = (Points(2, 2) << 0.1, 1.0 / 3, 0.2, 0.3).finished();
  scene.stiffness = std::make_shared<const Stiffness>(
      std::vector<StiffStroke>{{line, 0.1, 1000}, {line.leftCols(1), 1.0 / 7, 1}});
  scene.handles = {{4, 2, Vec2(0.1 + 0.2, -1e300), HandleKind::pin, 1},
                   {1, 0, Vec2(0, 5e-324), HandleKind::soft, 0.125, -1.0 / 3,
                    Turn{-1234.5, 1.0 / 7}, "Лапа \"left\"", StiffDisk{0.1, 1.0 / 3}}};
  scene.rig = {{{1, 4}}, Mirror{{{0.1, 0.2}, {1.0 / 3, -1e10}}, false}};
  scene.parameters = {"paper-noflip", 1e6, 0.5, 1e-3, 0.1, 7, 3, 1e-9, 0, false, false};
  scene.state = SceneState{scene.triangles, scene.rest, scene.rest * 0.7};
  scene.view = std::make_shared<const nlohmann::json>(
      nlohmann::json{{"camera", {{"centre", {0.5, 1.0}}, {"zoom", 2}}}, {"layers", {true, false}}});
  scene.description = "Look at the corner.";
  return scene;
}

void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.mesh_path, b.mesh_path);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.rest, b.rest);
  EXPECT_EQ(a.texture_path, b.texture_path);
  EXPECT_EQ(a.texture_box, b.texture_box);
  EXPECT_EQ(a.energy, b.energy);
  ASSERT_EQ(a.stiffness != nullptr, b.stiffness != nullptr);
  if (a.stiffness) {
    EXPECT_EQ(*a.stiffness, *b.stiffness);
  }
  EXPECT_EQ(a.handles, b.handles);
  EXPECT_EQ(a.rig, b.rig);
  EXPECT_EQ(a.parameters, b.parameters);
  EXPECT_EQ(a.description, b.description);
  ASSERT_EQ(a.state.has_value(), b.state.has_value());
  if (a.state) {
    EXPECT_EQ(a.state->triangles, b.state->triangles);
    EXPECT_EQ(a.state->rest, b.state->rest);
    EXPECT_EQ(a.state->deformed, b.state->deformed);
  }
  ASSERT_EQ(a.view != nullptr, b.view != nullptr);
  if (a.view) {
    EXPECT_EQ(*a.view, *b.view);
  }
}

TEST(SceneIo, LoadsAPlainScene) {
  const SceneFolder folder;
  const auto [scene, notices] = folder.load(kPlain);
  EXPECT_EQ(scene.rest.cols(), 5);
  EXPECT_EQ(scene.energy->name, "lscm");
  ASSERT_EQ(scene.handles.size(), 1u);
  EXPECT_EQ(scene.handles[0], (Handle{0, 2, Vec2(1.5, -0.25), HandleKind::drag, 1}));
  EXPECT_EQ(scene.parameters.delta, 1e-5);
  EXPECT_EQ(scene.parameters.eta, 0.01);
  EXPECT_EQ(scene.parameters.inner_iterations, Parameters().inner_iterations);
  EXPECT_FALSE(scene.parameters.beta);
  EXPECT_EQ(notices.size(), 1u) << "the vertex without a triangle";
}

TEST(SceneIo, GivesHandlesWithoutAnIdOneOfTheirOwn) {
  const SceneFolder folder;
  const Scene scene = folder
                          .load(R"({"mesh": "square.obj", "energy": "arap", "handles": [
                             {"vertex": 0, "target": [0, 0]}, {"vertex": 1, "target": [0, 0]},
                             {"vertex": 2, "target": [0, 0], "id": 1}]})")
                          .scene;
  EXPECT_EQ(scene.handles[0].id, 0);
  EXPECT_EQ(scene.handles[1].id, 2);
  EXPECT_EQ(scene.handles[2].id, 1);
}

TEST(SceneIo, ReadsBackAllThatItWroteExactly) {
  const SceneFolder folder;
  const Scene scene = full_scene();
  save_scene(scene, folder / "full.json");
  const Scene back = load_scene(folder / "full.json", test::kMethodNames).scene;
  expect_equal(scene, back);
  EXPECT_TRUE(std::signbit(back.rest(1, 1))) << "minus zero";
}

TEST(SceneIo, SavesAgainByteForByte) {
  const SceneFolder folder;
  for (const Scene& scene : {full_scene(), folder.load(kPlain).scene}) {
    save_scene(scene, folder / "a.json");
    save_scene(load_scene(folder / "a.json", test::kMethodNames).scene, folder / "b.json");
    EXPECT_EQ(read_file(folder / "a.json"), read_file(folder / "b.json"));
  }
}

TEST(SceneIo, LeavesDefaultsOut) {
  const SceneFolder folder;
  Scene scene = folder.load(kPlain).scene;
  const std::string text = scene_text(scene, scene.folder);
  EXPECT_NE(text.find("\"solver\": {\"eta\": 0.01}"), text.npos) << text;
  EXPECT_EQ(text.find("state"), text.npos);
}

TEST(SceneIo, KeepsPathsRightWhenSavedElsewhere) {
  const SceneFolder folder;
  fs::create_directories(folder / "deep/er");
  Scene scene = folder.load(kPlain).scene;
  scene.texture_path = "/somewhere/else.png";
  save_scene(scene, folder / "deep/er/moved.json");
  Scene moved = load_scene(folder / "deep/er/moved.json", test::kMethodNames).scene;
  EXPECT_EQ(moved.mesh_path, "../../square.obj");
  EXPECT_EQ(moved.texture_path, "/somewhere/else.png");
  EXPECT_EQ(moved.rest, scene.rest);
  move_to_folder(moved, scene.folder);
  EXPECT_EQ(moved.mesh_path, "square.obj");
}

TEST(SceneIo, TurnsAnInlineMeshOverWithANotice) {
  const SceneFolder folder;
  const auto [scene, notices] = folder.load(
      R"({"energy": "arap", "mesh": {"vertices": [[0,0],[1,0],[0,1]], "triangles": [[0,2,1]]}})");
  EXPECT_TRUE(is_injective(scene.triangles, scene.rest));
  EXPECT_EQ(notices.size(), 1u);
}

TEST(SceneIo, LetsHandlesNameVerticesOfTheState) {
  const SceneFolder folder;
  const std::string text =
      R"({"mesh": "square.obj", "energy": "arap", "handles": [{"vertex": 5, "target": [0.5, 0]}],
          "state": {"triangles": [[0,5,2],[5,1,2],[0,2,3]],
                    "rest": [[0,0],[1,0],[1,1],[0,1],[9,9],[0.5,0]],
                    "deformed": [[0,0],[1,0],[1,1],[0,1],[9,9],[0.5,-1]]}})";
  const Scene scene = folder.load(text).scene;
  ASSERT_TRUE(scene.state);
  EXPECT_EQ(scene.state->deformed(1, 5), -1);
  EXPECT_EQ(scene.handles[0].vertex, 5);
}

TEST(SceneIo, MakesASceneOfAMesh) {
  const SceneFolder folder;
  const auto [scene, notices] = scene_from_mesh(folder / "square.obj");
  EXPECT_TRUE(scene.handles.empty());
  EXPECT_EQ(scene.triangles.cols(), 2);
  ASSERT_TRUE(scene.energy);
  EXPECT_EQ(scene.folder / scene.mesh_path, folder / "square.obj");
  EXPECT_EQ(notices.size(), 1u);
}

TEST(SceneIo, SavesNoHalfFileWhenANumberIsNotFinite) {
  const SceneFolder folder;
  Scene scene = full_scene();
  scene.handles[0].target.x() = std::nan("");
  EXPECT_NE(test::error_of([&] { save_scene(scene, folder / "a.json"); }), "");
  EXPECT_FALSE(fs::exists(folder / "a.json"));
}

// Whatever the bytes are, a scene is refused with an Error that names a file, or it is valid.
TEST(SceneIo, SurvivesMutatedFiles) {
  const SceneFolder folder;
  const unsigned seed = 23;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::string full = scene_text(full_scene(), "/");
  int loaded = 0, refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::string text = test::mutated(i % 2 ? full : std::string(kPlain), random);
    try {
      const Scene scene = folder.load(text).scene;
      EXPECT_TRUE(is_injective(scene.triangles, scene.rest));
      if (scene.state) {
        EXPECT_TRUE(is_injective(scene.state->triangles, scene.state->rest, scene.state->deformed));
      }
      ++loaded;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with(folder.folder().path().string()))
          << error.what();
      ++refused;
    }
  }
  EXPECT_GT(loaded, 20);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace foldless
