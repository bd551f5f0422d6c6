// SPDX-License-Identifier: GPL-3.0-or-later
// Every mesh that a solve writes, before a judge that shares no code with the program.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/cli/command.h"
#include "tests/judge/judge.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::TemporaryFolder;

std::size_t judge_all(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    std::ifstream in(entry.path());
    EXPECT_EQ(judge::objections_to(judge::read_obj(in)), std::vector<std::string>{})
        << entry.path().filename();
    ++count;
  }
  return count;
}

/// Draws scenes from a seed and solves them with all frames; returns how many meshes were judged.
std::size_t judge_random_scenes(const std::string& seed, const std::string& only) {
  const TemporaryFolder folder;
  EXPECT_EQ(test::run({"bench", "--suite", "random", "--seed", seed, "--only", only, "--method",
                       "paper-noflip", "--time-limit", "0.01", "--keep", folder / "scenes"})
                .status,
            0);
  std::size_t count = 0;
  for (const auto& scene : fs::directory_iterator(folder / "scenes")) {
    const fs::path out = folder / scene.path().stem().string();
    const Ended ended =
        test::run({"solve", scene.path().string(), "-o", out.string(), "--frames", "all"});
    EXPECT_LE(ended.status, 1) << ended.err;
    count += judge_all(out);
  }
  return count;
}

TEST(JudgedFrames, OfRandomScenesAreAllLocallyInjective) {
  EXPECT_GT(judge_random_scenes("20", "0,5,11,17,23"), 50u);
}

}  // namespace
}  // namespace foldless
