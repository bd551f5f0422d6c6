// SPDX-License-Identifier: GPL-3.0-or-later
// Two threads at once. Where a race has two right results, both are accepted and each is checked.
#include <gtest/gtest.h>

#include <random>

#include "core/run/worker.h"
#include "tests/core/run/worker_fixture.h"

namespace foldless {
namespace {

using namespace std::chrono_literals;
using test::eventually;
using test::grid_problem;
using test::is_valid;
using test::reaches;
using test::Script;
using test::ScriptedWorker;
using test::starter_of;
using test::takes_up;
using test::targets_at;

TEST(WorkerRace, AMovedTargetReachesTheSolverWithinOneIteration) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  const Script& script = *scripted.script;
  scripted.script->stages = 8;
  scripted.script->stage_time = 200us;
  const Problem problem = grid_problem(3, Vec2(2, 2));
  worker.load(problem);
  worker.set_mode(WorkerMode::running);
  const Normalisation frame = foldless::Run(problem).normalisation();
  for (int k = 1; k <= 30; ++k) {
    const Points targets = targets_at(Vec2(2 + 0.01 * k, 2));
    worker.set_targets(targets);
    const int begun = script.begun;  // after it was posted: this thread may be held up before
    const Points seen = frame.to_unit(targets);
    ASSERT_TRUE(eventually([&] { return script.begun_when_seen(seen) >= 0; }));
    // The next iteration at the latest.
    EXPECT_LE(script.begun_when_seen(seen), begun + 1);
  }
}

TEST(WorkerRace, OnlyTheNewestOfManyTargetsCounts) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->stage_time = 5ms;
  worker.load(grid_problem(3, Vec2(2, 2)));
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] { return !worker.timeline().entries.empty(); }));
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k <= 1000; ++k) worker.set_targets(targets_at(Vec2(2, 2 + 1e-3 * k)));
  const auto took = std::chrono::steady_clock::now() - start;  // long where others work too
  ASSERT_TRUE(
      eventually([&] { return worker.latest()->handles[1].target == Vec2(2, 2 + 1e-3 * 1000); }));
  EXPECT_LT(scripted.script->begun, 500 + 2 * took / 5ms) << "every message cost an iteration";
}

TEST(WorkerRace, CancellingAtAnyMomentLeavesAValidMesh) {
  constexpr unsigned kSeed = 77;
  std::mt19937 random(kSeed);
  Worker worker;
  Problem problem = grid_problem(8, Vec2(3, 2));
  problem.energy = find_density("arap");
  for (int k = 0; k < 60; ++k) {
    const std::uint64_t generation = worker.load(problem);
    worker.set_mode(WorkerMode::running);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    worker.set_mode(WorkerMode::idle);
    ASSERT_TRUE(takes_up(worker, generation));
    ASSERT_TRUE(reaches(worker, WorkerState::idle)) << "seed " << kSeed << ", round " << k;
    ASSERT_EQ(worker.latest()->generation, generation);
    EXPECT_TRUE(is_valid(*worker.latest()));
    EXPECT_FALSE(worker.status().outcome);
  }
}

TEST(WorkerRace, PauseComesBeforeOrAfterTheEnd) {
  int paused = 0;
  for (int k = 0; k < 60; ++k) {
    ScriptedWorker scripted;
    Worker& worker = scripted.worker;
    scripted.script->length = 20;
    worker.load(grid_problem(3, Vec2(2, 2)));
    worker.set_mode(WorkerMode::running);
    std::this_thread::sleep_for(std::chrono::microseconds(10 * k));
    worker.set_mode(WorkerMode::paused);
    ASSERT_TRUE(eventually([&] {
      const WorkerState state = worker.status().state;
      return state == WorkerState::paused || state == WorkerState::finished;
    }));
    const WorkerStatus status = worker.status();
    EXPECT_EQ(status.outcome.has_value(), status.state == WorkerState::finished);
    EXPECT_EQ(worker.timeline().entries.size() == 20, status.state == WorkerState::finished);
    if (status.state != WorkerState::paused) continue;
    ++paused;
    worker.set_mode(WorkerMode::running);
    ASSERT_TRUE(reaches(worker, WorkerState::finished));
    EXPECT_EQ(worker.timeline().entries.size(), 20U);
  }
  RecordProperty("paused", paused);
}

TEST(WorkerRace, ALoadReplacesARunningProblem) {
  Worker worker;
  Problem hard = grid_problem(12, Vec2(2, 3));
  hard.energy = find_density("arap");
  worker.set_mode(WorkerMode::running);
  for (int k = 0; k < 40; ++k) {
    worker.load(hard);
    if (k % 4 == 0) std::this_thread::sleep_for(1ms);
    const int n = 3 + k % 3;
    const std::uint64_t generation = worker.load(grid_problem(n, Vec2(n - 1, n - 0.9)));
    EXPECT_TRUE(worker.timeline().entries.empty() ||
                worker.timeline().entries.front().snapshot->generation == generation);
    ASSERT_TRUE(eventually([&] {
      const WorkerStatus status = worker.status();
      return status.generation == generation && status.state == WorkerState::finished;
    }));
    EXPECT_EQ(worker.latest()->generation, generation);
    EXPECT_EQ(worker.latest()->deformed.cols(), n * n);
    for (const TimelineEntry& entry : worker.timeline().entries)
      EXPECT_EQ(entry.snapshot->generation, generation);
  }
}

TEST(WorkerRace, AClearedTimelineHoldsNoIterationBegunBefore) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->stage_time = 300us;
  worker.load(grid_problem(3, Vec2(2, 2)));
  worker.set_mode(WorkerMode::running);
  for (int k = 0; k < 40; ++k) {
    const int begun = scripted.script->begun;
    const std::uint64_t epoch = worker.timeline().epoch;
    worker.clear_timeline();
    EXPECT_EQ(worker.timeline().epoch, epoch + 1);
    ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() >= 3; }));
    const auto entries = worker.timeline().entries;
    EXPECT_GT(entries.front().record.inner, begun);
    for (std::size_t i = 1; i < entries.size(); ++i)
      EXPECT_EQ(entries[i].record.inner, entries[i - 1].record.inner + 1);
  }
}

TEST(WorkerRace, IsDestroyedWhileItRuns) {
  for (int k = 0; k < 60; ++k) {
    const auto script = std::make_shared<Script>();
    script->stages = 100000;
    script->stage_time = 100us;
    Worker worker({}, {.start = starter_of(script)});
    worker.load(grid_problem(3, Vec2(2, 2)));
    worker.set_mode(WorkerMode::running);
    std::this_thread::sleep_for(std::chrono::microseconds(37 * k));
  }
}

TEST(WorkerRace, AnyMessagesInAnyOrderLeaveAValidMeshAndAWorkerThatAnswers) {
  constexpr unsigned kSeed = 20140702;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-2, 8);
  Worker worker;
  Problem problem = grid_problem(6, Vec2(7, 6));
  for (int k = 0; k < 600; ++k) {
    Parameters parameters;
    parameters.method = random() % 2 ? "paper-flip" : "paper-noflip";
    switch (random() % 9) {
      case 0: worker.load(problem); break;
      case 1: worker.set_mode(WorkerMode::running); break;
      case 2: worker.set_mode(WorkerMode::paused); break;
      case 3: worker.step(); break;
      case 4: worker.set_mode(WorkerMode::idle); break;
      case 5: worker.set_parameters(find_density("arap"), parameters); break;
      case 6: worker.set_pace(1000.0 + static_cast<double>(random() % 5000)); break;
      case 7: worker.clear_timeline(); break;
      default: worker.set_targets(targets_at(Vec2(coordinate(random), coordinate(random)))); break;
    }
    if (random() % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(random() % 500));
    const auto latest = worker.latest();
    ASSERT_TRUE(!latest || is_valid(*latest)) << "seed " << kSeed;
  }
  const std::uint64_t last = worker.load(grid_problem(3, Vec2(2.1, 2.1)));
  worker.set_pace(std::nullopt);
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(takes_up(worker, last));
  EXPECT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_EQ(worker.status().error, "");
}

}  // namespace
}  // namespace foldless
