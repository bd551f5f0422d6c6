// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/files/mesh_io.h"
#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Command;
using test::Ended;
using test::grid_problem;
using test::TemporaryFolder;
using test::write_scene;

int colours_of(const Image& image) {
  std::set<std::vector<std::uint8_t>> colours;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) colours.insert({image.at(x, y), image.at(x, y) + 4});
  return static_cast<int>(colours.size());
}

TEST(EditorCall, GetsTheFileAndGivesTheStatus) {
  const auto open_editor = [](const std::optional<std::filesystem::path>& file,
                              const std::filesystem::path& record) {
    EXPECT_TRUE(record.empty());
    return file ? static_cast<int>(file->string().size()) : 40;
  };
  EXPECT_EQ(Command({}, {open_editor, {}}).wait().status, 40);
  EXPECT_EQ(Command({"abc.obj"}, {open_editor, {}}).wait().status, 7);
}

TEST(EditorCall, RecordsASession) {
  const auto open_editor = [](const std::optional<std::filesystem::path>&,
                              const std::filesystem::path& record) {
    return static_cast<int>(record.string().size());
  };
  EXPECT_EQ(Command({"--record", "s.jsonl"}, {open_editor, {}}).wait().status, 7);
}

TEST(ReplayCall, GetsTheSessionTheFolderAndTheSizeAndTellsTheNumberOfPictures) {
  const auto replay = [](const std::filesystem::path& session, const std::filesystem::path& shots,
                         const std::optional<std::array<int, 2>>& size) {
    return session == "s.jsonl" && shots == "out" && size == std::array{800, 600} ? 3 : 0;
  };
  const Ended ended =
      Command({"replay", "s.jsonl", "--shots", "out", "--size", "800x600"}, {{}, replay}).wait();
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "3 pictures in out\n");
  EXPECT_EQ(Command({"replay", "s.jsonl"}, {{}, replay}).wait().status, 2);
}

TEST(RenderCall, OfTheEditorGetsTheFileTheSizeAndTheTheme) {
  const TemporaryFolder folder;
  const auto picture = [](const std::filesystem::path& file,
                          const std::optional<std::array<int, 2>>& size,
                          std::optional<Theme> theme) {
    const bool is_right =
        file == "a.json" && size == std::array{800, 600} && theme == Theme::contrast;
    return Image(is_right ? 3 : 1, 2);
  };
  const Ended ended = Command({"render", "a.json", "-o", folder / "ui.png", "--ui", "--size",
                               "800x600", "--theme", "contrast"},
                              {{}, {}, picture})
                          .wait();
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(load_image(folder / "ui.png").width, 3);
}

TEST(EditorCall, SaysInALineWhyItDoesNotOpen) {
  const auto open_editor = [](const std::optional<std::filesystem::path>&,
                              const std::filesystem::path&) -> int {
    throw Error("no display:\nset DISPLAY");
  };
  const Ended ended = Command({}, {open_editor, {}}).wait();
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "foldless: no display: set DISPLAY\n");
}

TEST(Help, OfEveryCallEndsWithAnExample) {
  for (const std::string call :
       {"", "solve", "render", "mesh", "check", "compare", "replay", "bench"}) {
    const Ended ended = call.empty() ? test::run({"--help"}) : test::run({call, "--help"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.err, "");
    const std::size_t start = ended.out.rfind("Example:\n  foldless ");
    ASSERT_NE(start, std::string::npos) << ended.out;
    const std::string example = ended.out.substr(start + 9);
    EXPECT_EQ(std::ranges::count(example, '\n'), 1) << "the last line: " << example;
    EXPECT_NE(example.find("foldless " + call), std::string::npos);
    const std::size_t path = example.find('/');
    const std::string sample = example.substr(path, example.find_first_of(" \n", path) - path);
    EXPECT_TRUE(std::filesystem::exists(sample)) << "cannot be pasted: " << sample;
  }
}

TEST(Help, VersionIsOneLine) {
  const Ended ended = test::run({"--version"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_TRUE(ended.out.starts_with("foldless "));
  EXPECT_EQ(std::ranges::count(ended.out, '\n'), 1);
}

TEST(Help, VerboseVersionNamesWhatTheProgramWasBuiltWith) {
  const Ended ended = test::run({"--version", "--verbose"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_TRUE(ended.out.starts_with(test::run({"--version"}).out)) << ended.out;
  EXPECT_NE(ended.out.find("\nbuilt with "), std::string::npos);
  if (std::filesystem::exists("/var/lib/dpkg/status")) {
    EXPECT_NE(ended.out.find("\nlibsuitesparse-dev "), std::string::npos) << ended.out;
  }
  EXPECT_EQ(test::run({"--verbose"}).status, 2);
}

TEST(Check, ProvesWhatSolveWrites) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", grid_problem(5, Vec2(3, 3)));
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", folder / "out"}).status, 0);
  const Ended ended = test::run(
      {"check", folder / "out/rest.obj", folder / "out/deformed.obj", folder / "scene.json"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(std::ranges::count(ended.out, '\n'), 1);
  const json line = json::parse(ended.out);
  EXPECT_EQ(line["locally_injective"], true);
  EXPECT_EQ(line["ok"], true);
  EXPECT_EQ(line["satisfied"], true);
  EXPECT_EQ(line["original_vertices_kept"], true);
  EXPECT_EQ(line["vertices"], 25);
  EXPECT_EQ(line["handles"], 2);
  EXPECT_GT(line["min_area_ratio"], 0);
}

TEST(Check, FindsFoldsAndMissedHandles) {
  const TemporaryFolder folder;
  const Problem problem = grid_problem(5, Vec2(3, 3));
  write_scene(folder / "scene.json", problem);
  const MeshPair& mesh = problem.mesh;
  Points folded = mesh.rest();
  folded.col(12) += Vec2(1.5, 0);
  write_mesh(folder / "rest.obj", mesh.triangles(), mesh.rest());
  write_mesh(folder / "folded.obj", mesh.triangles(), folded);
  const Ended ended =
      test::run({"check", folder / "rest.obj", folder / "folded.obj", folder / "scene.json"});
  EXPECT_EQ(ended.status, 1);
  const json line = json::parse(ended.out);
  EXPECT_GT(line["flipped"], 0);
  EXPECT_EQ(line["locally_injective"], false);
  EXPECT_EQ(line["satisfied"], false);
  EXPECT_NEAR(line["handle_max_error"].get<double>(), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(line["problems"].size(), 2U);

  // Handles that are not reached are told, but are no fold.
  const Ended missed =
      test::run({"check", folder / "rest.obj", folder / "rest.obj", folder / "scene.json"});
  EXPECT_EQ(missed.status, 0);
  EXPECT_EQ(json::parse(missed.out)["ok"], false);
}

TEST(Check, SeesAVertexThatIsCoveredTwice) {
  // Eight triangles go twice round vertex 0: all are positive, and yet the map is not injective.
  const TemporaryFolder folder;
  test::Fixture fan;
  fan.rest.resize(2, 9);
  fan.rest.col(0).setZero();
  fan.triangles.resize(3, 8);
  Points twice = fan.rest;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * 3.14159265358979323846 / 4;
    fan.rest.col(k + 1) = Vec2(std::cos(angle), std::sin(angle));
    twice.col(k + 1) = Vec2(std::cos(2 * angle), std::sin(2 * angle));
    fan.triangles.col(k) << 0, k + 1, (k + 1) % 8 + 1;
  }
  twice.col(0).setZero();
  write_mesh(folder / "rest.obj", fan.triangles, fan.rest);
  write_mesh(folder / "twice.obj", fan.triangles, twice);
  const Ended ended = test::run({"check", folder / "rest.obj", folder / "twice.obj"});
  EXPECT_EQ(ended.status, 1);
  const json line = json::parse(ended.out);
  EXPECT_EQ(line["flipped"], 0);
  EXPECT_EQ(line["branch_vertices"], 1);
}

TEST(Check, SeesABoundaryVertexThatOverlapsItself) {
  const TemporaryFolder folder;
  const test::Fixture fan = test::open_fan(300);
  write_mesh(folder / "rest.obj", fan.triangles, fan.rest);
  write_mesh(folder / "round.obj", fan.triangles, test::open_fan(400).rest);
  const Ended ended = test::run({"check", folder / "rest.obj", folder / "round.obj"});
  EXPECT_EQ(ended.status, 1);
  const json line = json::parse(ended.out);
  EXPECT_EQ(line["flipped"], 0);
  EXPECT_EQ(line["branch_vertices"], 0);
  EXPECT_EQ(line["overlapping_boundary_vertices"], 1);
  EXPECT_EQ(line["rest_overlapping_boundary_vertices"], 0);
  EXPECT_EQ(line["locally_injective"], false);
  EXPECT_EQ(line["problems"][0],
            "1 boundary vertices overlap themselves in the deformed mesh, first vertex 0");
}

TEST(Render, DrawsScenesFoldersAndPairs) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", grid_problem(5, Vec2(3, 3)));
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", folder / "out"}).status, 0);
  const std::string pair = folder / "out/rest.obj" + "," + folder / "out/deformed.obj";
  const std::vector<std::string> subjects{folder / "scene.json", folder / "out", pair,
                                          folder / "out/deformed.obj"};
  for (const std::string& subject : subjects) {
    const Ended ended =
        test::run({"render", subject, "-o", folder / "picture.png", "--size", "320x200"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Image picture = load_image(folder / "picture.png");
    EXPECT_EQ(picture.width, 320);
    EXPECT_EQ(picture.height, 200);
    EXPECT_GT(colours_of(picture), 8) << subject;
  }
}

TEST(Render, OptionsChangeThePicture) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", grid_problem(5, Vec2(3, 3)));
  const auto draw = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{
        "render", folder / "scene.json", "-o", folder / "picture.png", "--size", "200x150"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = test::run(arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return load_image(folder / "picture.png");
  };
  const Image plain = draw({});
  EXPECT_EQ(draw({}), plain) << "the same call draws the same picture";
  EXPECT_NE(draw({"--view", "both"}), plain);
  EXPECT_NE(draw({"--layers", "fill,heat"}), plain);
  const Image transparent = draw({"--transparent"});
  EXPECT_EQ(transparent.at(0, 0)[3], 0);
  EXPECT_EQ(plain.at(0, 0)[3], 255);
}

}  // namespace
}  // namespace foldless
