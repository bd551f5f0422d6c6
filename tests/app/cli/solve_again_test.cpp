// SPDX-License-Identifier: GPL-3.0-or-later
// What a solve into the folder of an earlier one replaces, and what it leaves.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <stdexcept>
#include <thread>

#include "tests/app/cli/result_reader.h"
#include "tests/app/cli/solved.h"
#include "tests/support/number_from.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;
using test::Command;
using test::Ended;
using test::expect_no_leftovers;
using test::Files;
using test::flipping_problem;
using test::names_in;
using test::read_text;
using test::result_in;
using test::TemporaryFolder;
using test::write_text;

/// Solves into out/ of a folder that has the scene.
Ended solve_again(const TemporaryFolder& folder, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments{"solve", folder / "scene.json", "-o", folder / "out"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return test::run(arguments);
}

TEST(SolveAgain, LeavesWhatItDidNotWriteWhereItIs) {
  const TemporaryFolder folder;
  test::write_scene(folder / "scene.json", flipping_problem());
  fs::create_directories(folder / "out/frames");
  fs::create_directories(folder / "elsewhere");
  for (const char* name : {"out/frames/000001.png", "out/deformed.png", "out/frames/notes.txt",
                           "elsewhere/000000.obj", "out/.rest.obj.aB3xYz"})
    write_text(folder / name, "mine");
  ASSERT_EQ(solve_again(folder).status, 0);
  ASSERT_EQ(solve_again(folder).status, 0);
  EXPECT_EQ(read_text(folder / "out/frames/000001.png"), "mine");
  EXPECT_EQ(read_text(folder / "out/deformed.png"), "mine");
  EXPECT_EQ(read_text(folder / "out/.rest.obj.aB3xYz"), "mine");
  fs::remove_all(folder / "out/frames");
  write_text(folder / "out/frames", "a file of mine");
  ASSERT_EQ(solve_again(folder).status, 0);
  EXPECT_EQ(read_text(folder / "out/frames"), "a file of mine");
  fs::remove(folder / "out/frames");
  fs::create_directory_symlink(folder / "elsewhere", folder / "out/frames");
  ASSERT_EQ(solve_again(folder).status, 0);
  EXPECT_EQ(names_in(folder / "elsewhere"), std::vector<std::string>{"000000.obj"});
}

TEST(SolveAgain, RefusesToReplaceWhatItDidNotWrite) {
  const TemporaryFolder folder;
  test::write_scene(folder / "scene.json", flipping_problem());
  fs::create_directories(folder / "elsewhere");
  const auto expect_refusal = [&](const std::string& name) {
    const Ended ended = solve_again(folder, {"--frames", "all"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(ended.err.starts_with("foldless: " + (folder / name) + ":")) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    expect_no_leftovers(folder / "out");
  };
  for (const char* name :
       {"out/rest.obj", "out/frames", "out/frames/000007.png", "out/manifest.json"}) {
    fs::create_directories(fs::path(folder / name).parent_path());
    write_text(folder / name, "mine");
    expect_refusal(name);
    EXPECT_EQ(read_text(folder / name), "mine");
    fs::remove_all(folder / "out");
  }
  fs::create_directory(folder / "out");
  fs::create_directory_symlink(folder / "elsewhere", folder / "out/frames");
  expect_refusal("out/frames");
  EXPECT_EQ(names_in(folder / "elsewhere"), std::vector<std::string>{});
  fs::remove(folder / "out/frames");

  ASSERT_EQ(solve_again(folder, {"--frames", "all"}).status, 0);
  const Files before = result_in(folder / "out");
  write_text(folder / "out/deformed.obj", before.at("deformed.obj") + "# by hand\n");
  expect_refusal("out/deformed.obj");
  EXPECT_TRUE(read_text(folder / "out/deformed.obj").ends_with("# by hand\n"));
}

/// FOLDLESS_KILLS says how often, FOLDLESS_SEED where the random moments begin.
TEST(SolveAgain, KilledAtAnyMomentItLeavesAWholeResult) {
  const TemporaryFolder folder;
  test::write_scene(folder / "scene.json", flipping_problem());
  const std::vector<std::vector<std::string>> kinds{
      {"--frames", "all", "--method", "paper"}, {"--frames", "2", "--energy", "arap"}, {}};
  std::vector<Files> meshes;  // of each kind; a report tells its seconds
  const auto meshes_in = [&] {
    Files files = result_in(folder / "out");
    for (const char* name : {"report.json", "iterations.csv"}) EXPECT_EQ(files.erase(name), 1U);
    return files;
  };
  const auto start = std::chrono::steady_clock::now();
  for (const auto& options : kinds) {
    solve_again(folder, options);
    meshes.push_back(meshes_in());
    ASSERT_EQ(names_in(folder / "out/frames").size() + 2, meshes.back().size());
  }
  auto longest = (std::chrono::steady_clock::now() - start) / kinds.size();
  write_text(folder / "out/notes.txt", "mine");

  const auto kills = static_cast<std::size_t>(test::number_from("FOLDLESS_KILLS", 60));
  std::mt19937 random(static_cast<unsigned>(test::number_from("FOLDLESS_SEED", 7)));
  std::size_t last = kinds.size() - 1;  // the kind whose result is there
  std::size_t killed = 0;
  for (std::size_t i = 0; killed < kills && i < 5 * kills; ++i) {
    std::vector<std::string> arguments{"solve", folder / "scene.json", "-o", folder / "out"};
    const auto& options = kinds[i % kinds.size()];
    arguments.insert(arguments.end(), options.begin(), options.end());
    Command command(arguments);
    std::this_thread::sleep_for(longest * std::uniform_real_distribution(0.0, 1.2)(random));
    command.send(SIGKILL);
    const bool was_killed = command.wait().status < 0;
    if (was_killed) ++killed;
    longest = was_killed ? longest * 51 / 50 : longest * 9 / 10;  // about the end of a run
    const Files found = meshes_in();
    if (found == meshes[i % kinds.size()]) last = i % kinds.size();
    EXPECT_EQ(found, meshes[last]) << "neither the old nor the new result, kill " << i;
  }
  EXPECT_EQ(killed, kills) << "they came too late";
  EXPECT_EQ(read_text(folder / "out/notes.txt"), "mine");
  solve_again(folder);
  expect_no_leftovers(folder / "out");
  EXPECT_EQ(meshes_in(), meshes.back());
}

/// Solves once more under a condition that does not let it write; the result before stays.
template <typename Refuse>
void expect_earlier_result_stays(const std::string& words, const Refuse& solve) {
  const TemporaryFolder folder;
  test::write_scene(folder / "scene.json", flipping_problem());
  ASSERT_EQ(solve_again(folder, {"--frames", "5"}).status, 0);
  const Files before = result_in(folder / "out");
  const Ended ended = solve(folder);
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
  EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  EXPECT_EQ(ended.err.find("-staged"), std::string::npos) << "a name within: " << ended.err;
  EXPECT_EQ(result_in(folder / "out"), before);
  expect_no_leftovers(folder / "out");
}

TEST(SolveAgain, AFullDiskLeavesTheEarlierResult) {
  // No file of this process and its children may grow beyond this, as on a disk that is full.
  expect_earlier_result_stays("File too large", [](const TemporaryFolder& folder) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{500, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const Ended ended = solve_again(folder);
    setrlimit(RLIMIT_FSIZE, &before);
    return ended;
  });
}

TEST(SolveAgain, AReadOnlyFolderLeavesTheEarlierResult) {
  expect_earlier_result_stays("cannot be written to", [](const TemporaryFolder& folder) {
    const bool is_root = geteuid() == 0;  // whom permissions do not stop
    fs::permissions(folder / "out", fs::perms(0555));
    fs::permissions(folder.path(), fs::perms(0755));
    if (is_root && seteuid(65534) != 0) throw std::runtime_error("root stays root");
    const Ended ended = solve_again(folder);
    if (is_root && seteuid(0) != 0) throw std::runtime_error("root is gone");
    fs::permissions(folder / "out", fs::perms(0755));
    return ended;
  });
}

}  // namespace
}  // namespace foldless
