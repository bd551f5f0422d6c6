// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that may fold: what they write, and how they say it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files/mesh_io.h"
#include "core/files/validate.h"
#include "core/mesh/injective.h"
#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Ended;
using test::read_text;
using test::TemporaryFolder;
using test::write_scene;

/// A grid whose corners are held and whose middle is pulled over its neighbours.
Problem folding_problem() {
  Problem problem = test::grid_problem(5, Vec2(4, 4));
  const auto hold = [&](int vertex, const Vec2& target) {
    problem.handles.push_back(
        {.id = 10 + vertex, .vertex = vertex, .target = target, .kind = HandleKind::drag});
  };
  hold(4, Vec2(4, 0));
  hold(20, Vec2(0, 4));
  hold(12, Vec2(3.6, 3.4));
  return problem;
}

TEST(Baselines, AFoldedResultIsWrittenAndSaysSo) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", folding_problem());
  const Ended ended =
      test::run({"solve", folder / "scene.json", "-o", folder / "out", "--method",
                 "injective-projection", "--bound", "1.5", "--inner", "1", "--frames", "all"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.out.find("the map is not locally injective"), std::string::npos) << ended.out;
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_GT(report["folded"], 0);
  EXPECT_EQ(report["inverted"], report["folded"]);
  EXPECT_EQ(report["satisfied"], false);
  EXPECT_EQ(report["parameters"]["distortion_bound"], 1.5);
  EXPECT_EQ(report["parameters"]["start"], "continuation");
  EXPECT_LT(report["min_area_ratio"], 0);
  EXPECT_TRUE(report["energy"]["total"].is_number());
  EXPECT_FALSE(report["verdict"].get<std::string>().empty());
  const Ended check = test::run({"check", folder / "out/rest.obj", folder / "out/deformed.obj"});
  EXPECT_EQ(check.status, 1);
  EXPECT_EQ(json::parse(check.out)["flipped"], report["folded"]);
  // It can be looked at.
  EXPECT_EQ(test::run({"render", folder / "out", "-o", folder / "folded.png"}).status, 0);
}

TEST(Baselines, BoundedConformalKeepsItsBound) {
  const TemporaryFolder folder;
  Problem problem = folding_problem();
  problem.handles.back().target = Vec2(2.6, 2.4);
  write_scene(folder / "scene.json", problem);
  for (const char* start : {"rest", "unconstrained", "continuation"}) {
    const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--method",
                                   "bounded-conformal", "--bound", "8", "--start", start});
    EXPECT_EQ(ended.status, 0) << start << ": " << ended.out << ended.err;
    const json report = json::parse(read_text(folder / "out/report.json"));
    EXPECT_EQ(report["parameters"]["start"], start);
    EXPECT_LE(report["conformal_distortion"]["max"].get<double>(), 8 * (1 + 1e-4));
    EXPECT_EQ(report["folded"], 0);
    EXPECT_EQ(report["branch_vertices"], 0);
    EXPECT_TRUE(report["overlapping_boundary_vertices"].is_number());
    EXPECT_FALSE(report.contains("verdict"));
  }
}

TEST(Baselines, InfeasibleIsAnOutcomeWithAVerdict) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", folding_problem());
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--method",
                                 "bounded-conformal", "--bound", "1.2", "--start", "rest"});
  EXPECT_EQ(ended.status, 1);
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(report["outcome"], "infeasible");
  EXPECT_EQ(report["verdict"], "infeasible for these frames (certificate)");
  EXPECT_NE(ended.out.find("infeasible for these frames (certificate)"), std::string::npos);
  EXPECT_EQ(report["inverted"], 0);
}

TEST(Baselines, WhatTheyCannotDoIsRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", folding_problem());
  const auto solve = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"solve", folder / "scene.json", "-o", folder / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  };
  const Ended energy = solve({"--method", "bounded-conformal", "--energy", "green-strain"});
  EXPECT_EQ(energy.status, 2);
  EXPECT_NE(energy.err.find("has no energy 'green-strain'; choose dirichlet, lscm or arap"),
            std::string::npos)
      << energy.err;
  const Ended start = solve({"--start", "later"});
  EXPECT_EQ(start.status, 2);
  EXPECT_NE(start.err.find("choose one of: rest, unconstrained, continuation"), std::string::npos)
      << start.err;
  const Ended bound = solve({"--bound", "1"});
  EXPECT_EQ(bound.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace foldless
