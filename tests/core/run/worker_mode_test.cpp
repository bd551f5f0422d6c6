// SPDX-License-Identifier: GPL-3.0-or-later
// run(), pause(), step() and stop(), with iterations that are held while messages are posted.
#include <gtest/gtest.h>

#include "tests/core/run/held_worker.h"

namespace foldless {
namespace {

using test::eventually;
using test::HeldWorker;
using test::reaches;
using test::recorded;
using test::ScriptedWorker;
using test::takes_up_all;
using test::targets_at;

TEST(WorkerMode, AStepWhileItRunsIsTheLastIteration) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.step();
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(reaches(held.worker, WorkerState::paused));
  EXPECT_EQ(recorded(held.worker), (std::vector<int>{1, 2}));
}

TEST(WorkerMode, AStepThatIsCancelledIsMadeUpFor) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.step();
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.set_targets(targets_at(Vec2(2, 3)));
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(reaches(held.worker, WorkerState::paused));
  EXPECT_EQ(held.script->begun, 2);
  EXPECT_EQ(held.script->cancelled, 1);
  EXPECT_EQ(recorded(held.worker), (std::vector<int>{1}));
}

TEST(WorkerMode, AStepThatAFinishedRunCannotMakeIsForgotten) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->length = 1;
  worker.load(test::small_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  worker.step();
  ASSERT_TRUE(takes_up_all(worker));
  worker.set_targets(targets_at(Vec2(2, 3)));
  ASSERT_TRUE(takes_up_all(worker));
  EXPECT_EQ(worker.status().state, WorkerState::paused);
  EXPECT_EQ(scripted.script->begun, 1);
}

TEST(WorkerMode, PauseAndStopTakeBackAStep) {
  for (const WorkerState state : {WorkerState::paused, WorkerState::idle}) {
    HeldWorker held;
    held.worker.load(test::small_problem());
    held.worker.set_mode(WorkerMode::running);
    ASSERT_TRUE(held.gate.holds_the_solver());
    held.worker.step();
    if (state == WorkerState::paused)
      held.worker.set_mode(WorkerMode::paused);
    else
      held.worker.set_mode(WorkerMode::idle);
    held.gate.let_through();
    ASSERT_TRUE(reaches(held.worker, state));
    EXPECT_EQ(held.script->begun, 1);
  }
}

TEST(WorkerMode, AStoppedRunGoesOnWhereItWas) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.step();
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(reaches(held.worker, WorkerState::paused));
  held.worker.set_mode(WorkerMode::idle);
  ASSERT_TRUE(reaches(held.worker, WorkerState::idle));
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(recorded(held.worker), (std::vector<int>{1, 2}));
}

TEST(WorkerMode, AFinishedRunThatIsStoppedIsIdleUntilItRuns) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  scripted.script->length = 1;
  worker.load(test::small_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  worker.set_mode(WorkerMode::idle);
  ASSERT_TRUE(takes_up_all(worker));
  EXPECT_EQ(worker.status().state, WorkerState::idle);
  EXPECT_FALSE(worker.status().outcome);
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::finished));
  EXPECT_EQ(scripted.script->begun, 1);
}

TEST(WorkerMode, AFinishedRunBeginsAgainUnlessItWasPaused) {
  const std::vector<std::function<void(Worker&)>> messages = {
      [](Worker& worker) { worker.set_targets(targets_at(Vec2(2, 3))); },
      [](Worker& worker) { worker.set_parameters(find_density("arap"), {}); },
      [](Worker& worker) { worker.load(test::small_problem()); }};
  for (std::size_t m = 0; m < messages.size(); ++m) {
    ScriptedWorker scripted;
    Worker& worker = scripted.worker;
    scripted.script->length = 2;
    worker.load(test::small_problem());
    worker.set_mode(WorkerMode::running);
    ASSERT_TRUE(reaches(worker, WorkerState::finished));
    messages[m](worker);
    ASSERT_TRUE(eventually([&] { return scripted.script->begun == 4; })) << m;
    ASSERT_TRUE(reaches(worker, WorkerState::finished));

    worker.set_mode(WorkerMode::paused);
    messages[m](worker);
    ASSERT_TRUE(takes_up_all(worker));
    EXPECT_EQ(worker.status().state, WorkerState::paused) << m;
    EXPECT_EQ(scripted.script->begun, 4) << m;
  }
}

TEST(WorkerMode, APauseHoldsThoughTheLoadThatCameWithItIsRefused) {
  HeldWorker held;
  Worker& worker = held.worker;
  worker.load(test::small_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  Problem folded = test::small_problem();
  test::displace(folded.mesh, 4, Vec2(5, 5));
  worker.set_mode(WorkerMode::paused);
  worker.load(folded);
  held.gate.let_through();
  ASSERT_TRUE(eventually([&] { return !worker.status().error.empty(); }));
  worker.load(test::small_problem());
  ASSERT_TRUE(takes_up_all(worker));
  EXPECT_EQ(worker.status().state, WorkerState::paused);
  EXPECT_EQ(held.script->begun, 1);
}

// A step has no pace, and no message waits for its turn.
TEST(WorkerMode, ASlowPaceHoldsUpNeitherTheFirstIterationNorStepsNorMessages) {
  ScriptedWorker scripted;
  Worker& worker = scripted.worker;
  worker.set_pace(1e-300);
  worker.load(test::small_problem());
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() == 1; }));
  worker.step();
  ASSERT_TRUE(eventually([&] { return worker.timeline().entries.size() == 2; }));
  ASSERT_TRUE(reaches(worker, WorkerState::paused));
  worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(worker, WorkerState::running));
  worker.set_targets(targets_at(Vec2(2, 3)));
  EXPECT_TRUE(eventually([&] { return worker.latest()->handles[1].target == Vec2(2, 3); }));
  worker.set_pace(std::nullopt);
  EXPECT_TRUE(eventually([&] { return worker.timeline().entries.size() > 4; }));
}

}  // namespace
}  // namespace foldless
