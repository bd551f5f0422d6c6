// SPDX-License-Identifier: GPL-3.0-or-later
// Every allocation of a thread in the background fails, one after the other: that ends what the
// thread does, with words for the user, and never the program.
#include <gtest/gtest.h>

#include <chrono>
#include <latch>
#include <thread>

#include "app/bench/bench_pool.h"
#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/run/background_bake.h"
#include "core/run/background_frames.h"
#include "core/run/background_moment.h"
#include "core/run/stop_watch.h"
#include "core/run/worker.h"
#include "tests/core/run/scripted_method.h"
#include "tests/support/failing_allocation.h"
#include "tests/support/patience.h"

namespace foldless::test {
namespace {

constexpr const char* kWords = "there is not enough memory";

/// Of the first hundred all, then one of an eighth more every time.
long next_after(long n) { return n < 100 ? n + 1 : n + n / 8; }

/// A square of which a corner moves, in three frames.
AnimationToSolve moving_square() {
  AnimationToSolve wanted;
  wanted.at_rest = grid_problem(3, Vec2(2, 2));
  wanted.at_rest.energy = find_density("arap");
  wanted.animation.cycle = {3, false};
  HandleTracks tracks;
  tracks.handle = 2;
  tracks.position = {{0, Vec2(2, 2), {}}, {2, Vec2(2.5, 2.2), {}}};
  wanted.animation.tracks.push_back(tracks);
  return wanted;
}

TEST(ShortMemory, OfTheSolverIsItsError) {
  int failed = 0;
  for (long n = 1;; n = next_after(n)) {
    Worker worker({}, {.threads = 1});
    const FailingAllocation failing(n);
    worker.load(grid_problem(3, Vec2(2.5, 2.5)));
    worker.set_mode(WorkerMode::running);
    const auto has_ended = [&] {
      const WorkerStatus status = worker.status();
      return status.state == WorkerState::finished || !status.error.empty();
    };
    ASSERT_TRUE(comes_true(has_ended)) << n;
    if (!failing.has_happened()) break;
    if (const std::string error = worker.status().error; !error.empty()) {
      EXPECT_EQ(error, kWords) << n;
      ++failed;
    }
    worker.load(grid_problem(3, Vec2(2.5, 2.5)));
    const auto goes_on = [&] { return worker.status().state == WorkerState::finished; };
    ASSERT_TRUE(comes_true(goes_on)) << n;
  }
  EXPECT_GT(failed, 50);
}

TEST(ShortMemory, IsNothingToAWatchWhichNeedsNone) {
  const FailingAllocation failing(1);
  const StopWatch watch({.time_limit = {}, .is_interrupted = [] { return true; }});
  EXPECT_TRUE(comes_true([&] { return watch.token().stop_requested(); }));
  EXPECT_FALSE(failing.has_happened());
}

TEST(ShortMemory, OfFramesIsTheirError) {
  const AnimationToSolve wanted = moving_square();
  int failed = 0;
  for (long n = 1;; n = next_after(n)) {
    BackgroundFrames frames;
    const FailingAllocation failing(n);
    frames.solve(wanted);
    const auto has_ended = [&] {
      const FramesStatus status = frames.status();
      return status.is_done || !status.error.empty();
    };
    ASSERT_TRUE(comes_true(has_ended)) << n;
    const FramesStatus status = frames.status();
    if (!failing.has_happened()) {
      EXPECT_EQ(status.solved, 3U);
      break;
    }
    EXPECT_TRUE(status.is_done ? status.solved == 3 : status.error == kWords) << n << status.error;
    failed += status.is_done ? 0 : 1;
  }
  EXPECT_GT(failed, 50);
}

TEST(ShortMemory, OfABakeIsItsError) {
  const AnimationToSolve wanted = moving_square();
  const auto frames = std::make_shared<const Frames>(wanted.at_rest, wanted.animation);
  SolvedToBake solved;
  solved.solved = solve_animation(*frames, {{0, 1, 2}}, {})->frames;
  int failed = 0;
  for (long n = 1;; n = next_after(n)) {
    BackgroundBake bake;
    const FailingAllocation failing(n);
    bake.start(frames, solved);
    ASSERT_TRUE(comes_true([&] { return bake.result() != nullptr; })) << n;
    if (!failing.has_happened()) break;
    const std::string error = bake.result()->error;
    EXPECT_TRUE(error.empty() || error == kWords) << n << error;
    failed += error.empty() ? 0 : 1;
  }
  EXPECT_GT(failed, 20);
}

TEST(ShortMemory, OfAMomentLeavesItUnsolved) {
  const AnimationToSolve wanted = moving_square();
  const auto frames = std::make_shared<const Frames>(wanted.at_rest, wanted.animation);
  const auto first =
      std::make_shared<const SolvedFrame>(solve_animation(*frames, {{0}}, {})->frames.front());
  for (long n = 1;; n = next_after(n)) {
    BackgroundMoment moments;
    {
      const FailingAllocation failing(n);
      const auto is_over = [&] {
        return failing.has_happened() || moments.at(0.5, first, frames) != nullptr;
      };
      ASSERT_TRUE(comes_true(is_over)) << n;
      if (!failing.has_happened()) break;
    }
    const auto goes_on = [&] { return moments.at(0.25, first, frames) != nullptr; };
    ASSERT_TRUE(comes_true(goes_on)) << n;
  }
}

TEST(ShortMemory, OfAJobKeepsNoOtherFromBeingDone) {
  LatestJob jobs;
  std::latch began(1), ran(1);
  jobs.start([&](const std::stop_token&) {
    began.count_down();
    throw std::bad_alloc();
  });
  began.wait();
  jobs.start([&](const std::stop_token&) { ran.count_down(); });
  ran.wait();
}

TEST(ShortMemory, OfABenchEndsIt) {
  BenchScene scene{"scene", "", {}};
  const Problem problem = grid_problem(3, Vec2(2.5, 2.5));
  scene.scene.triangles = problem.mesh.triangles();
  scene.scene.rest = problem.mesh.rest();
  scene.scene.energy = problem.energy;
  scene.scene.handles = problem.handles;
  const std::vector<BenchJob> jobs(2, {&scene, scene.scene.parameters});
  int failed = 0;
  for (long n = 1;; n = next_after(n)) {
    const FailingAllocation failing(n);
    try {
      EXPECT_EQ(run_jobs(jobs, {.threads = 2}, {}).size(), 2U);
    } catch (const std::bad_alloc&) {
      ++failed;
    }
    if (!failing.has_happened()) break;
  }
  EXPECT_GT(failed, 50);
}

}  // namespace
}  // namespace foldless::test
