// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "render/image.h"
#include "tests/app/cli/command.h"
#include "tests/app/cli/solved.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Ended;
using test::expect_valid_results;
using test::flipping_problem;
using test::grid_problem;
using test::lines_of;
using test::names_in;
using test::read_text;
using test::TemporaryFolder;
using test::write_scene;

TEST(Solve, WritesTheMeshesTheReportAndTheIterations) {
  const TemporaryFolder folder;
  const Problem problem = flipping_problem();
  write_scene(folder / "scene.json", problem);
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out/deep"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const std::string out = folder / "out/deep";
  EXPECT_EQ(names_in(out), (std::vector<std::string>{"deformed.obj", "iterations.csv",
                                                     "manifest.json", "report.json", "rest.obj"}));
  expect_valid_results(out);
  EXPECT_EQ(read_mesh(out + "/rest.obj").points, problem.mesh.rest());
  EXPECT_LT((read_mesh(out + "/deformed.obj").points.col(35) - Vec2(2.5, 2.2)).norm(), 1e-4);
}

TEST(Solve, ReportHasEveryKeyAndAgreesWithTheMeshes) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", folder / "out"}).status, 0);
  const json report = json::parse(read_text(folder / "out/report.json"));
  for (const char* key : {"scene",
                          "method",
                          "energy",
                          "parameters",
                          "vertices",
                          "faces",
                          "original_vertices",
                          "original_faces",
                          "outcome",
                          "satisfied",
                          "handle_error_squared",
                          "factorizations",
                          "updates",
                          "iterations",
                          "outer_iterations",
                          "flips",
                          "splits",
                          "gradient_norm_squared",
                          "conformal_distortion",
                          "min_area_ratio",
                          "inverted",
                          "seconds"})
    EXPECT_TRUE(report.contains(key)) << key;
  for (const char* key : {"distortion", "barrier", "penalty", "total"})
    EXPECT_TRUE(report["energy"][key].is_number()) << key;
  for (const char* key : {"total", "assemble", "factorize"})
    EXPECT_GT(report["seconds"][key].get<double>(), 0) << key;
  EXPECT_EQ(report["energy"]["name"], "lscm");
  EXPECT_EQ(report["method"], "foldless");
  EXPECT_EQ(report["vertices"], 36);
  EXPECT_EQ(report["inverted"], 0);
  EXPECT_EQ(report["overlapping_boundary_vertices"], 0);
  EXPECT_EQ(report["satisfied"], true);
  EXPECT_GT(report["flips"], 0);
  const Vec2 reached = read_mesh(folder / "out/deformed.obj").points.col(35);
  EXPECT_NEAR(report["handle_error_squared"].get<double>(),
              (reached - Vec2(2.5, 2.2)).squaredNorm(), 1e-9);
  EXPECT_GE(report["conformal_distortion"]["max"], report["conformal_distortion"]["mean"]);
}

TEST(Solve, ReportCountsWhatTheRunCounts) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", folder / "out"}).status, 0);
  const json report = json::parse(read_text(folder / "out/report.json"));
  foldless::Run run(flipping_problem());
  Iteration last;
  while (const std::optional<Iteration> next = run.step({})) last = *next;
  EXPECT_GT(last.factorizations, 0);
  EXPECT_EQ(report["factorizations"], last.factorizations);
  EXPECT_EQ(report["updates"], last.updates);
}

TEST(Solve, WritesARowAnUpdate) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  ASSERT_EQ(
      test::run({"solve", folder / "scene.json", "-o", folder / "out", "--method", "paper"}).status,
      0);
  const auto lines = lines_of(read_text(folder / "out/iterations.csv"));
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(lines.size(), 1 + report["iterations"].get<std::size_t>());
  EXPECT_TRUE(
      lines[0].starts_with("outer,inner,phase,E_d,E_c,E_b,E,gradient_norm_squared,"
                           "handle_error_squared,step_infinity_norm,mu,step_length,flips,"
                           "splits,min_area_ratio,seconds"));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    double E_d = 0, E_c = 0, E_b = 0, E = 0;
    int outer = 0, inner = 0;
    std::string phase = lines[i];
    std::ranges::replace(phase, ',', ' ');
    std::istringstream row(phase);
    ASSERT_TRUE(row >> outer >> inner >> phase >> E_d >> E_c >> E_b >> E) << lines[i];
    EXPECT_TRUE(phase == "update" || phase == "relax");
    EXPECT_NEAR(E_d + E_c + E_b, E, 1e-12 * E);
  }
}

TEST(Solve, EndsWithOneWhenHandlesAreNotReached) {
  const TemporaryFolder folder;
  // Through the opposite corner: no single update gets there.
  write_scene(folder / "scene.json", grid_problem(6, Vec2(-3, -3)));
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--inner",
                                 "1", "--outer", "1", "--method", "paper"});
  EXPECT_EQ(ended.status, 1);
  expect_valid_results(folder / "out");
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(report["outcome"], "iteration-limit");
  EXPECT_EQ(report["satisfied"], false);
  EXPECT_EQ(report["updates"], 1);
}

TEST(Solve, SaysWhyWhenItIsProvedThatHandlesCannotBeReached) {
  const TemporaryFolder folder;
  Problem problem = grid_problem(5, Vec2(4, 4));
  problem.handles = {{.id = 1, .vertex = 12, .target = Vec2(6, 2)}};
  for (int v = 0; v < 25; ++v)
    if (problem.mesh.is_boundary_vertex(v))
      problem.handles.push_back({.id = v + 2, .vertex = v, .target = problem.mesh.rest().col(v)});
  write_scene(folder / "scene.json", problem);
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 1);
  const std::string why = "infeasible: vertex 12 is to go out of the held boundary, or onto it";
  EXPECT_NE(ended.out.find("handles are not all reached (" + why + ")"), std::string::npos)
      << ended.out;
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(report["outcome"], "infeasible");
  EXPECT_EQ(report["verdict"], why);
  EXPECT_EQ(report["satisfied"], false);
  expect_valid_results(folder / "out");
}

TEST(Solve, OptionsOverrideTheScene) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  test::run({"solve",     folder / "scene.json",
             "-o",        folder / "out",
             "--method",  "paper-noflip",
             "--energy",  "arap",
             "--alpha",   "1e6",
             "--beta",    "0.5",
             "--delta",   "1e-4",
             "--eta",     "0.002",
             "--inner",   "12",
             "--outer",   "3",
             "--threads", "1"});
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(report["method"], "paper-noflip");
  EXPECT_EQ(report["energy"]["name"], "arap");
  EXPECT_EQ(report["parameters"]["alpha"], 1e6);
  EXPECT_EQ(report["parameters"]["beta"], 0.5);
  EXPECT_EQ(report["parameters"]["delta"], 1e-4);
  EXPECT_EQ(report["parameters"]["eta"], 0.002);
  EXPECT_EQ(report["parameters"]["inner_iterations"], 12);
  EXPECT_EQ(report["parameters"]["outer_iterations"], 3);
  EXPECT_EQ(report["flips"], 0);
}

TEST(Solve, JsonPrintsTheReportAndNothingElse) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--json"});
  EXPECT_EQ(ended.out, read_text(folder / "out/report.json"));
  EXPECT_EQ(ended.err, "");
}

TEST(Solve, QuietPrintsNothing) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--quiet"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out + ended.err, "");
}

TEST(Solve, SolvesASceneWithoutHandles) {
  const TemporaryFolder folder;
  Problem problem = flipping_problem();
  problem.handles.clear();
  write_scene(folder / "scene.json", problem);
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(read_mesh(folder / "out/deformed.obj").points.isApprox(problem.mesh.rest(), 1e-12));
}

TEST(Solve, WritesEveryMeshAsAFrame) {
  const TemporaryFolder folder;
  const Problem problem = flipping_problem();
  write_scene(folder / "scene.json", problem);
  const std::string out = folder / "out";
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", out, "--frames", "all"}).status, 0);
  const json report = json::parse(read_text(out + "/report.json"));
  const auto frames = names_in(out + "/frames");
  ASSERT_EQ(frames.size(), 1 + report["iterations"].get<std::size_t>());
  EXPECT_EQ(frames.front(), "000000.obj");
  for (const std::string& frame : frames)
    EXPECT_NO_THROW(read_mesh(out + "/frames/" + frame)) << "a frame that is not valid";
  EXPECT_EQ(read_mesh(out + "/frames/" + frames.front()).points, problem.mesh.rest());
  EXPECT_EQ(read_text(out + "/frames/" + frames.back()), read_text(out + "/deformed.obj"));
}

TEST(Solve, ThinsFramesAndRemovesThoseOfAnEarlierRun) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  const std::string out = folder / "out";
  test::run({"solve", folder / "scene.json", "-o", out, "--frames", "all"});
  const std::size_t all = names_in(out + "/frames").size();
  ASSERT_GT(all, 5U);
  test::write_text(out + "/frames/notes.txt", "mine");
  test::run({"solve", folder / "scene.json", "-o", out, "--frames", "4"});
  auto frames = names_in(out + "/frames");
  ASSERT_EQ(frames.back(), "notes.txt") << "what is not a frame was removed";
  frames.pop_back();
  EXPECT_EQ(frames.size(), (all - 1) / 4 + 1 + ((all - 1) % 4 == 0 ? 0 : 1));
  EXPECT_EQ(read_text(out + "/frames/" + frames.back()), read_text(out + "/deformed.obj"));
  test::run({"solve", folder / "scene.json", "-o", out});
  EXPECT_EQ(names_in(out + "/frames"), std::vector<std::string>{"notes.txt"});
}

TEST(Solve, DrawsTheResultAndEveryFrame) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  const std::string out = folder / "out";
  const Ended ended = test::run(
      {"solve", folder / "scene.json", "-o", out, "--frames", "5", "--render", "--threads", "1"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto frames = names_in(out + "/frames");
  for (const std::string& frame : frames)
    EXPECT_TRUE(std::ranges::count(frames, frame.substr(0, 6) + ".png")) << frame;
  const Image picture = load_image(out + "/deformed.png");
  EXPECT_EQ(picture.width, 1200);
  EXPECT_EQ(picture.height, 900);
}

}  // namespace
}  // namespace foldless
