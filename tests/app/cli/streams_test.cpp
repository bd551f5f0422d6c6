// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/streams.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/files/mesh_io.h"
#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::Command;
using test::Ended;
using test::TemporaryFolder;

/// /dev/full, and a stdout that is closed.
const std::vector<fs::path> kNowhere{"/dev/full", ""};

void expect_told_that_output_is_lost(const std::vector<std::string>& arguments) {
  for (const fs::path& nowhere : kNowhere) {
    const Ended ended = Command(arguments, nowhere).wait();
    EXPECT_EQ(ended.status, 2) << arguments[0];
    EXPECT_TRUE(ended.err.starts_with("foldless: standard output ")) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

TEST(Streams, EveryCallThatPrintsTellsWhenThatIsLost) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  const std::string out = folder / "out";
  test::write_scene(scene, test::grid_problem(4, Vec2(0.6, 0.6)));
  expect_told_that_output_is_lost({"--help"});
  expect_told_that_output_is_lost({"--version"});
  expect_told_that_output_is_lost({"solve", "--help"});
  expect_told_that_output_is_lost({"solve", scene, "-o", out});
  expect_told_that_output_is_lost({"solve", scene, "-o", out, "--json"});
  expect_told_that_output_is_lost({"check", out + "/rest.obj", out + "/deformed.obj"});
  expect_told_that_output_is_lost({"bench", scene, "--method", "lim", "-o", folder / "table"});
  EXPECT_NO_THROW(read_mesh(out + "/deformed.obj")) << "files are written all the same";
  EXPECT_EQ(test::names_in(folder / "table").size(), 5U);
}

TEST(Streams, WhatPrintsNothingNeedsNone) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  test::write_scene(scene, test::grid_problem(4, Vec2(0.6, 0.6)));
  for (const fs::path& nowhere : kNowhere) {
    const Ended ended = Command({"solve", scene, "-o", folder / "out", "--quiet"}, nowhere).wait();
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
  }
}

}  // namespace
}  // namespace foldless
