// SPDX-License-Identifier: GPL-3.0-or-later
// A solve that is interrupted or runs out of time.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/cli/command.h"
#include "tests/app/cli/solved.h"

namespace foldless {
namespace {

using nlohmann::json;
using test::Command;
using test::Ended;
using test::expect_valid_results;
using test::flipping_problem;
using test::grid_problem;
using test::lines_of;
using test::names_in;
using test::read_text;
using test::TemporaryFolder;
using test::write_scene;

/// A scene of so many vertices in a row; 120 take some 200 frames.
Problem long_problem(int n) {
  Problem problem = grid_problem(n, Vec2(2, 3));
  problem.energy = find_density("arap");
  return problem;
}

/// Interrupts a solve once it has written some frames, and checks what it leaves.
void interrupt_with(int signal) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", long_problem(120));
  const std::string out = folder / "out";
  for (const std::size_t frames : {1U, 4U, 9U}) {
    const Ended ended = test::interrupt(
        {"solve", folder / "scene.json", "-o", out, "--frames", "all"}, signal,
        [&](const Command&) { return names_in(out + "/.foldless-staged/frames").size() >= frames; },
        [&] { std::filesystem::remove_all(out); });
    expect_valid_results(out);
    const json report = json::parse(read_text(out + "/report.json"));
    EXPECT_EQ(ended.status, 130) << "interrupted after " << frames << " frames";
    EXPECT_EQ(report["outcome"], "cancelled");
    EXPECT_EQ(lines_of(read_text(out + "/iterations.csv")).size(),
              1 + report["iterations"].get<std::size_t>());
    for (const std::string& frame : names_in(out + "/frames"))
      EXPECT_NO_THROW(read_mesh(out + "/frames/" + frame));
    std::filesystem::remove_all(out);
  }
}

TEST(Solve, InterruptedItWritesTheLastValidMesh) { interrupt_with(SIGINT); }

TEST(Solve, InterruptedWhileItReadsItEndsWithTheStatusOfAnInterruption) {
  const TemporaryFolder folder;
  const std::string scene = folder / "scene.json";
  ASSERT_EQ(::mkfifo(scene.c_str(), 0600), 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Command command({"solve", scene, "-o", folder / "out"});
    const int pipe = ::open(scene.c_str(), O_WRONLY);  // once it reads
    ASSERT_GE(pipe, 0);
    command.send(signal);
    EXPECT_EQ(command.wait().status, 130) << signal;
    ::close(pipe);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(Solve, GoesOnWhereSignalsAreIgnored) {
  // As in background jobs of a script and under nohup: processes inherit what is ignored.
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", long_problem(40));
  const auto before_int = std::signal(SIGINT, SIG_IGN);
  const auto before_term = std::signal(SIGTERM, SIG_IGN);
  const std::string out = folder / "out";
  Command command({"solve", folder / "scene.json", "-o", out, "--frames", "all"});
  std::signal(SIGINT, before_int);
  std::signal(SIGTERM, before_term);
  while (command.is_running() && names_in(out + "/.foldless-staged/frames").empty())
    std::this_thread::yield();
  command.send(SIGINT);
  command.send(SIGTERM);
  EXPECT_EQ(command.wait().status, 0);
  EXPECT_EQ(json::parse(read_text(out + "/report.json"))["outcome"], "gradient");
}

TEST(Solve, EndsWithOneWhenTheTimeIsOver) {
  const TemporaryFolder folder;
  Problem problem = grid_problem(150, Vec2(2, 3));  // takes minutes
  problem.energy = find_density("arap");
  write_scene(folder / "scene.json", problem);
  const Ended ended = test::run({"solve", folder / "scene.json", "-o", folder / "out", "--method",
                                 "paper-noflip", "--time-limit", "0.5"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.out.find("time-limit"), std::string::npos) << ended.out;
  expect_valid_results(folder / "out");
  const json report = json::parse(read_text(folder / "out/report.json"));
  EXPECT_EQ(report["outcome"], "time-limit");
  EXPECT_GT(report["seconds"]["total"].get<double>(), 0.3);
  EXPECT_LT(report["seconds"]["total"].get<double>(), 2) << "processor time, whatever else runs";
}

TEST(Solve, ATimeLimitThatIsNotReachedChangesNothing) {
  const TemporaryFolder folder;
  write_scene(folder / "scene.json", flipping_problem());
  const std::string out = folder / "out", other = folder / "other";
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", out}).status, 0);
  ASSERT_EQ(test::run({"solve", folder / "scene.json", "-o", other, "--time-limit", "500"}).status,
            0);
  EXPECT_EQ(read_text(out + "/deformed.obj"), read_text(other + "/deformed.obj"));
}

TEST(Solve, TerminatedItWritesTheLastValidMesh) { interrupt_with(SIGTERM); }

}  // namespace
}  // namespace foldless
