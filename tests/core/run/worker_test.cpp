// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/worker.h"

#include <gtest/gtest.h>

#include <atomic>

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

Problem easy_problem() { return grid_problem(4, Vec2(3.3, 3.1)); }

TEST(Worker, IsIdleBeforeTheFirstLoad) {
  const Worker worker;
  EXPECT_EQ(worker.latest(), nullptr);
  EXPECT_EQ(worker.status(), WorkerStatus{});
  EXPECT_TRUE(worker.timeline().entries.empty());
}

TEST(Worker, ShowsTheProblemsMeshAndWaitsForRun) {
  Worker worker;
  const std::uint64_t generation = worker.load(easy_problem());
  ASSERT_TRUE(takes_up(worker, generation));
  EXPECT_EQ(worker.status().state, WorkerState::idle);
  ASSERT_TRUE(worker.latest());
  EXPECT_EQ(worker.latest()->generation, generation);
  EXPECT_FALSE(worker.latest()->iteration);
}

TEST(Worker, SolvesToTheEnd) {
  Worker worker;
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  const WorkerStatus status = worker.status();
  EXPECT_TRUE(status.outcome);
  EXPECT_TRUE(status.satisfied);
  EXPECT_EQ(status.error, "");
  EXPECT_LT((worker.latest()->deformed.col(15) - Vec2(3.3, 3.1)).norm(), 1e-4);
}

TEST(Worker, LogsEveryIterationInOrder) {
  ScriptedWorker scripted;
  scripted.script->length = 500;
  scripted.worker.load(easy_problem());
  scripted.worker.set_mode(WorkerMode::running);
  // A reader that copies what is new while it is written ends with the same log.
  std::vector<TimelineEntry> copy;
  ASSERT_TRUE(eventually([&] {
    const bool is_finished = scripted.worker.status().state == WorkerState::finished;
    for (TimelineEntry& entry : scripted.worker.timeline(copy.size()).entries)
      copy.push_back(entry);
    return is_finished;
  }));
  ASSERT_EQ(copy.size(), 500U);
  for (std::size_t i = 0; i < copy.size(); ++i) {
    EXPECT_EQ(copy[i].record.inner, static_cast<int>(i) + 1);
    ASSERT_TRUE(copy[i].snapshot);
    EXPECT_EQ(copy[i].snapshot->iteration->inner, copy[i].record.inner);
  }
}

TEST(Worker, ThinsSnapshotsButNoRecords) {
  const auto script = std::make_shared<Script>();
  script->length = 300;
  Worker worker({}, {.timeline_bytes = 20'000, .start = starter_of(script)});
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  const auto entries = worker.timeline().entries;
  ASSERT_EQ(entries.size(), 300U);
  EXPECT_LT(std::ranges::count_if(entries, [](const auto& e) { return e.snapshot != nullptr; }),
            100);
  EXPECT_TRUE(entries.front().snapshot);
  EXPECT_TRUE(entries.back().snapshot);
}

TEST(Worker, StepsOnceAndPauses) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::paused);
  for (std::size_t k = 1; k <= 3; ++k) {
    worker.step();
    ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() == k; }));
    ASSERT_TRUE(reaches(worker, WorkerState::paused));
  }
  std::this_thread::sleep_for(5ms);
  EXPECT_EQ(worker.timeline().entries.size(), 3U);
}

TEST(Worker, PausesAndGoesOnWithoutLosingAnIteration) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->stage_time = 50us;
  worker.load(easy_problem());
  for (int k = 0; k < 20; ++k) {
    worker.set_mode(WorkerMode::running);
    const std::size_t before = worker.timeline().entries.size();
    ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() > before; }));
    worker.set_mode(WorkerMode::paused);
    ASSERT_TRUE(reaches(worker, WorkerState::paused));
    const std::size_t paused = worker.timeline().entries.size();
    std::this_thread::sleep_for(1ms);
    EXPECT_EQ(worker.timeline().entries.size(), paused);
  }
  const auto entries = worker.timeline().entries;
  for (std::size_t i = 0; i < entries.size(); ++i)
    EXPECT_EQ(entries[i].record.inner, static_cast<int>(i) + 1);
}

TEST(Worker, StopsAndKeepsTheSnapshot) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->stages = 1000;
  scripted.script->stage_time = 1ms;
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] { return scripted.script->begun > 0; }));
  worker.set_mode(WorkerMode::idle);
  ASSERT_TRUE(reaches(worker, WorkerState::idle));
  EXPECT_EQ(scripted.script->cancelled, 1) << "an iteration of a second was waited for";
  EXPECT_TRUE(is_valid(*worker.latest()));
}

TEST(Worker, ANewLoadWaitsWhilePausedAndRunsAfterAFinishedRun) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->length = 5;
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  const std::uint64_t second = worker.load(easy_problem());
  ASSERT_TRUE(takes_up(worker, second));
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_EQ(worker.timeline().entries.size(), 5U);

  worker.set_mode(WorkerMode::paused);
  const std::uint64_t third = worker.load(easy_problem());
  ASSERT_TRUE(takes_up(worker, third));
  EXPECT_EQ(worker.status().state, WorkerState::paused);
  EXPECT_TRUE(worker.timeline().entries.empty());
  EXPECT_FALSE(worker.latest()->iteration);
}

TEST(Worker, NewTargetsWakeAFinishedRun) {
  Worker worker;
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  Points targets(2, 2);
  targets << 0, 3.0,  //
      0, 3.5;
  worker.clear_timeline();
  worker.set_targets(targets);
  ASSERT_TRUE(eventually([&] {
    return worker.latest()->handles[1].target == Vec2(3, 3.5) &&
           worker.status().state == WorkerState::finished && !worker.timeline().entries.empty();
  }));
  EXPECT_TRUE(worker.status().satisfied);
}

TEST(Worker, NewParametersGoOnFromTheSameMesh) {
  Worker worker;
  worker.load(grid_problem(6, Vec2(4, 4)));
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  worker.set_mode(WorkerMode::paused);
  const auto before = worker.latest();
  Parameters parameters;
  parameters.alpha = 1e6;
  worker.set_parameters(find_density("symmetric-dirichlet"), parameters);
  ASSERT_TRUE(reaches(worker, WorkerState::paused));
  EXPECT_EQ(worker.latest()->deformed, before->deformed);
  EXPECT_EQ(worker.latest()->generation, before->generation);
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_NE(worker.latest()->deformed, before->deformed);
}

TEST(Worker, KeepsItsPace) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  worker.load(easy_problem());
  worker.set_pace(50);
  const auto start = std::chrono::steady_clock::now();
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() >= 6; }));
  // Never faster; how much slower depends on the machine.
  EXPECT_GE(std::chrono::steady_clock::now() - start, 5 * 20ms - 1ms);

  // A slow pace holds up neither messages nor single steps.
  worker.set_pace(0.001);
  worker.set_mode(WorkerMode::paused);
  ASSERT_TRUE(reaches(worker, WorkerState::paused));
  const std::size_t before = worker.timeline().entries.size();
  worker.step();
  EXPECT_TRUE(eventually([&] { return worker.timeline().entries.size() == before + 1; }));

  worker.set_pace(std::nullopt);
  worker.set_mode(WorkerMode::running);
  EXPECT_TRUE(eventually([&] { return worker.timeline().entries.size() >= before + 100; }));
}

TEST(Worker, PublishesOnlyValidMeshes) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->length = 300;
  scripted.script->change = [](MeshPair& mesh, int k) {
    test::displace(mesh, 5, k % 2 == 0 ? Vec2(-0.9, -0.9) : Vec2(0.9, 0.9));
  };
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] {
    const auto latest = worker.latest();
    EXPECT_TRUE(!latest || is_valid(*latest));
    return worker.status().state == WorkerState::finished;
  }));
  const auto entries = worker.timeline().entries;
  ASSERT_EQ(entries.size(), 300U);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].snapshot == nullptr, i % 2 == 0) << i;
    EXPECT_TRUE(!entries[i].snapshot || is_valid(*entries[i].snapshot));
  }
}

TEST(Worker, SaysInWordsThatARunCannotGoOn) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->change = [](MeshPair&, int k) {
    if (k == 3) throw std::runtime_error("the third iteration does not work");
  };
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] { return !worker.status().error.empty(); }));
  EXPECT_EQ(worker.status().error, "the third iteration does not work");
  EXPECT_EQ(worker.status().state, WorkerState::idle);
  EXPECT_TRUE(is_valid(*worker.latest()));
  EXPECT_EQ(worker.timeline().entries.size(), 2U);

  scripted.script->change = nullptr;
  scripted.script->length = 4;
  worker.load(easy_problem());
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_EQ(worker.status().error, "");
}

TEST(Worker, RefusesAFoldedProblemAndShowsTheOneBefore) {
  Worker worker;
  ASSERT_TRUE(takes_up(worker, worker.load(easy_problem())));
  const auto before = worker.latest();
  Problem folded = easy_problem();
  test::displace(folded.mesh, 5, Vec2(5, 5));
  ASSERT_TRUE(takes_up(worker, worker.load(folded)));
  EXPECT_NE(worker.status().error, "");
  EXPECT_EQ(worker.latest(), before);
}

TEST(Worker, WakesItsReader) {
  std::atomic<int> wakes = 0;
  const auto script = std::make_shared<Script>();
  script->length = 20;
  Worker worker([&wakes] { ++wakes; }, {.start = starter_of(script)});
  worker.load(easy_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_TRUE(eventually([&] { return wakes >= 21; }));
}

}  // namespace
}  // namespace foldless
