// SPDX-License-Identifier: GPL-3.0-or-later
// Which messages cancel a running iteration. The iterations are held while the messages are posted.
#include <gtest/gtest.h>

#include <atomic>
#include <future>

#include "tests/core/run/held_worker.h"

namespace foldless {
namespace {

using namespace std::chrono_literals;
using test::eventually;
using test::HeldWorker;
using test::reaches;
using test::recorded;
using test::targets_at;

// The first of these tests, as a lock that is held would make the others hang.
TEST(WorkerCancel, EveryCallReturnsWhileAnIterationRuns) {
  HeldWorker held;
  Worker& worker = held.worker;
  worker.load(test::small_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  const auto calls = std::async(std::launch::async, [&] {
    worker.load(test::small_problem());
    worker.set_targets(targets_at(Vec2(2, 3)));
    worker.set_parameters(find_density("arap"), {});
    worker.set_pace(1e6);
    worker.step();
    worker.set_mode(WorkerMode::idle);
    worker.set_mode(WorkerMode::running);
    worker.set_mode(WorkerMode::paused);
    worker.clear_timeline();
    worker.latest();
    worker.status();
    worker.timeline();
  });
  EXPECT_EQ(calls.wait_for(test::kPatience), std::future_status::ready);
  held.gate.open();
}

/// Posts in every iteration while it runs: only every second one may be cancelled.
template <typename Post>
void expect_that_the_solver_gets_on(const Post& post) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  for (int k = 1; k <= 8; ++k) {
    ASSERT_TRUE(held.gate.holds_the_solver());
    EXPECT_EQ(held.script->begun, k);
    EXPECT_EQ(held.script->cancelled, k / 2);
    EXPECT_EQ(held.worker.timeline().entries.size(), static_cast<std::size_t>((k - 1) / 2));
    post(held.worker, k);
    held.gate.let_through();
  }
}

TEST(WorkerCancel, AStreamOfTargetsDoesNotStarveTheSolver) {
  expect_that_the_solver_gets_on(
      [](Worker& worker, int k) { worker.set_targets(targets_at(Vec2(2, 2 + 0.1 * k))); });
}

TEST(WorkerCancel, AStreamOfParametersDoesNotStarveTheSolver) {
  expect_that_the_solver_gets_on([](Worker& worker, int k) {
    Parameters parameters;
    parameters.alpha = k;
    worker.set_parameters(find_density("arap"), parameters);
  });
}

TEST(WorkerCancel, EveryLoadCancels) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  for (int k = 1; k <= 4; ++k) {
    ASSERT_TRUE(held.gate.holds_the_solver());
    EXPECT_EQ(held.script->begun, k);
    EXPECT_EQ(held.script->cancelled, k - 1);
    held.worker.load(test::small_problem());
    held.gate.let_through();
  }
}

TEST(WorkerCancel, StopCancelsAnIterationThatFollowsACancelledOne) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.set_targets(targets_at(Vec2(2, 3)));
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.set_mode(WorkerMode::idle);
  held.gate.let_through();
  ASSERT_TRUE(reaches(held.worker, WorkerState::idle));
  EXPECT_EQ(held.script->begun, 2);
  EXPECT_EQ(held.script->cancelled, 2);
}

TEST(WorkerCancel, RunPauseStepAndPaceLeaveTheIterationToItsEnd) {
  const std::vector<std::function<void(Worker&)>> messages = {
      [](Worker& worker) { worker.set_mode(WorkerMode::running); },
      [](Worker& worker) { worker.set_mode(WorkerMode::paused); },
      [](Worker& worker) { worker.step(); }, [](Worker& worker) { worker.set_pace(1e9); }};
  for (std::size_t m = 0; m < messages.size(); ++m) {
    HeldWorker held;
    held.worker.load(test::small_problem());
    held.worker.set_mode(WorkerMode::running);
    ASSERT_TRUE(held.gate.holds_the_solver());
    messages[m](held.worker);
    held.gate.let_through();
    EXPECT_TRUE(eventually([&] { return held.worker.timeline().entries.size() == 1; })) << m;
    EXPECT_EQ(held.script->cancelled, 0) << m;
  }
}

TEST(WorkerCancel, TheNewestSnapshotStandsWhateverIsCancelled) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  const auto before = held.worker.latest();
  ASSERT_TRUE(before->iteration);
  held.worker.set_mode(WorkerMode::idle);
  held.gate.let_through();
  ASSERT_TRUE(reaches(held.worker, WorkerState::idle));
  EXPECT_EQ(held.script->cancelled, 1);
  EXPECT_EQ(held.worker.latest(), before);
  EXPECT_EQ(recorded(held.worker), (std::vector<int>{1}));
}

TEST(WorkerCancel, TheDestructorDoesNotWaitForTheIteration) {
  bool was_asked_to_stop = false;
  std::atomic<bool> is_running = false;
  {
    test::ScriptedWorker scripted;
    scripted.script->look = [&](const std::stop_token& token) {
      is_running = true;
      was_asked_to_stop = eventually([&] { return token.stop_requested(); });
    };
    scripted.worker.load(test::small_problem());
    scripted.worker.set_mode(WorkerMode::running);
    ASSERT_TRUE(eventually([&] { return is_running.load(); }));
  }
  EXPECT_TRUE(was_asked_to_stop);
}

}  // namespace
}  // namespace foldless
