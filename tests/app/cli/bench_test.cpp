// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/app/cli/command.h"
#include "tests/core/run/scripted_method.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Command;
using test::Ended;
using test::names_in;
using test::read_text;
using test::TemporaryFolder;

TEST(Bench, RunsMethodsOverRandomScenesAndWritesTables) {
  const TemporaryFolder folder;
  const Ended ended = test::run({"bench", "--suite", "random", "--seed", "3", "--only", "0,6",
                                 "--method", "paper-noflip,paper-flip", "--jobs", "2", "-o",
                                 folder / "out", "--keep", folder / "scenes"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_NE(ended.out.find("H ratio"), std::string::npos) << ended.out;
  EXPECT_EQ(names_in(folder / "out"),
            (std::vector<std::string>{"results.csv", "results.json", "runs.tex", "summary.md",
                                      "summary.tex"}));
  const json rows = json::parse(read_text(folder / "out/results.json"));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0]["method"], "paper-noflip");
  EXPECT_EQ(rows[1]["method"], "paper-flip");
  EXPECT_EQ(rows[0]["scene"], rows[1]["scene"]);
  EXPECT_EQ(names_in(folder / "scenes").size(), 2u);
}

TEST(Bench, AKeptSceneIsSolvedTheSameWay) {
  const TemporaryFolder folder;
  test::run({"bench", "--suite", "random", "--seed", "3", "--only", "2", "--method", "foldless",
             "-o", folder / "out", "--keep", folder / "scenes"});
  const json row = json::parse(read_text(folder / "out/results.json"))[0];
  const std::string scene = folder / ("scenes/" + row["scene"].get<std::string>() + ".json");
  const Ended solved =
      test::run({"solve", scene, "-o", folder / "solved", "--method", "foldless", "--json"});
  const json report = json::parse(solved.out);
  EXPECT_EQ(report["factorizations"], row["factorizations"]);
  EXPECT_EQ(report["satisfied"], row["satisfied"]);
  EXPECT_EQ(report["energy"]["name"], row["energy"]);
  EXPECT_NEAR(report["energy"]["distortion"].get<double>(), row["E_d"].get<double>(),
              1e-9 * std::abs(row["E_d"].get<double>()));
}

TEST(Bench, TellsWhichKindsOfHardScenesAreReached) {
  const TemporaryFolder folder;
  const Ended ended = test::run(
      {"bench", "--suite", "hard", "--only", "1,5", "--method", "foldless", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 0);
  for (const char* words : {"\ncomb          1/1", "\nstrip         1/1"})
    EXPECT_NE(ended.out.find(words), std::string::npos) << ended.out;
}

TEST(Bench, FollowsDragsFrameByFrame) {
  const TemporaryFolder folder;
  const Ended ended = test::run({"bench", "--suite", "drag", "--only", "0", "--method",
                                 "foldless,paper-flip", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("first ms"), std::string::npos) << ended.out;
  EXPECT_EQ(names_in(folder / "out"),
            (std::vector<std::string>{"frames.csv", "results.csv", "results.json", "summary.md",
                                      "summary.tex"}));
  const json rows = json::parse(read_text(folder / "out/results.json"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["method"], "foldless");
  EXPECT_EQ(rows[0]["frames"], 140);
  EXPECT_EQ(rows[0]["invalid_frames"], 0);
}

TEST(Bench, TakesSceneFiles) {
  const TemporaryFolder folder;
  test::write_scene(folder / "one.json", test::grid_problem(4, Vec2(0.6, 0.6)));
  const Ended ended = test::run({"bench", folder / "one.json", "--method", "paper-flip"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("one "), std::string::npos) << ended.out;
}

TEST(Bench, ReproducesAPartOfThePaper) {
  const TemporaryFolder folder;
  const Ended ended = test::run({"bench", "--suite", "paper", "--only", "0", "--method",
                                 "paper-noflip,paper-flip", "-o", folder / "out"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("187/77"), std::string::npos) << "the paper's own figures";
  EXPECT_EQ(names_in(folder / "out"),
            (std::vector<std::string>{"figure13_coarse_disk_energy.svg",
                                      "figure13_coarse_disk_gradient.svg", "results.csv",
                                      "results.json", "table1.csv", "table1.md", "table1.tex"}));
}

void interrupt_bench_with(int signal) {
  const TemporaryFolder folder;
  const Ended ended = test::interrupt(
      {"bench", "--suite", "random", "--only", "5,23", "--method", "paper-noflip", "-o",
       folder / "out", "--keep", folder / "scenes"},
      signal, [&](const Command&) { return names_in(folder / "scenes").size() == 2; },
      [&] {
        for (const char* name : {"out", "scenes"}) std::filesystem::remove_all(folder / name);
      });
  EXPECT_EQ(ended.status, 130);
  EXPECT_EQ(names_in(folder / "out"),
            (std::vector<std::string>{"results.csv", "results.json", "runs.tex", "summary.md",
                                      "summary.tex"}));
}

TEST(Bench, InterruptedOrTerminatedItWritesWhatIsThere) {
  interrupt_bench_with(SIGINT);
  interrupt_bench_with(SIGTERM);
}

TEST(Bench, LeavesNoEmptyFolderWhereItCannotBegin) {
  const TemporaryFolder folder;
  const Ended ended = test::run({"bench", folder / "none.json", "-o", folder / "a/out"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "a/out"));
}

TEST(Bench, LeavesNoEmptyFolderForScenesThatItCannotWrite) {
  const TemporaryFolder folder;
  test::write_scene(folder / "one.json", test::grid_problem(4, Vec2(0.6, 0.6)));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{20, before.rlim_max};  // as on a disk that is full
  setrlimit(RLIMIT_FSIZE, &small);
  const Ended ended = test::run({"bench", folder / "one.json", "--keep", folder / "kept"});
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(ended.status, 2) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "kept"));
}

TEST(Bench, RefusesScenesThatThereAreNot) {
  const TemporaryFolder folder;
  test::write_scene(folder / "one.json", test::grid_problem(4, Vec2(0.6, 0.6)));
  for (const std::vector<std::string>& scenes : {std::vector<std::string>{folder / "one.json"},
                                                 {"--suite", "random"},
                                                 {"--suite", "paper"},
                                                 {"--suite", "drag"},
                                                 {"--suite", "hard"},
                                                 {"--suite", "scale"}}) {
    std::vector<std::string> arguments{"bench", "--only", "999999", "-o", folder / "out"};
    arguments.insert(arguments.end(), scenes.begin(), scenes.end());
    const Ended ended = test::run(arguments);
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("--only 999999: there is no such scene, only "), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(Bench, RefusesWhatItDoesNotUnderstand) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"bench"},
        {"bench", "--suite", "all"},
        {"bench", "--suite", "random", "x.json"},
        {"bench", "--suite", "random", "--only", "-1"},
        {"bench", "--suite", "random", "--method", "magic"},
        {"bench", "--suite", "random", "--jobs", "0"},
        {"bench", "--suite", "random", "-o", "/dev/null/folder"},
        {"bench", "missing.json"}}) {
    const Ended ended = test::run(arguments);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

}  // namespace
}  // namespace foldless
