// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of several messages that come during one iteration, which is held meanwhile.
#include <gtest/gtest.h>

#include <mutex>

#include "tests/core/run/held_worker.h"

namespace foldless {
namespace {

using test::grid_problem;
using test::HeldWorker;
using test::recorded;
using test::takes_up;
using test::targets_at;

/// What methods were started on.
struct Notes {
  std::mutex mutex;
  const Density* energy = nullptr;
  Parameters parameters;
  int started = 0;
};

/// A worker that notes what its methods are started on.
struct NotingWorker : Notes, HeldWorker {
  NotingWorker() {
    script->start = [this](const Problem& problem) {
      std::lock_guard lock(mutex);
      energy = problem.energy;
      parameters = problem.parameters;
      ++started;
    };
  }

  /// Loads the problem and runs it up to the gate in its first iteration.
  bool runs(const Problem& problem) {
    worker.load(problem);
    worker.set_mode(WorkerMode::running);
    return gate.holds_the_solver();
  }
};

TEST(WorkerInbox, ALoadDropsTheTargetsAndParametersBeforeIt) {
  NotingWorker held;
  ASSERT_TRUE(held.runs(test::small_problem()));
  Parameters parameters;
  parameters.alpha = 77;
  held.worker.set_targets(targets_at(Vec2(9, 9)));
  held.worker.set_parameters(find_density("arap"), parameters);
  const Problem next = grid_problem(4, Vec2(3, 4));
  held.worker.load(next);
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(held.worker.latest()->handles, next.handles);
  std::lock_guard lock(held.mutex);
  EXPECT_EQ(held.started, 2);
  EXPECT_EQ(held.energy, next.energy);
  EXPECT_EQ(held.parameters.alpha, next.parameters.alpha);
}

TEST(WorkerInbox, TargetsAndParametersAfterALoadAreItsOwn) {
  NotingWorker held;
  ASSERT_TRUE(held.runs(test::small_problem()));
  Parameters parameters;
  parameters.alpha = 77;
  held.worker.load(grid_problem(4, Vec2(3, 4)));
  held.worker.set_targets(targets_at(Vec2(9, 9)));
  held.worker.set_parameters(find_density("arap"), parameters);
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(held.script->begun, 2) << "an iteration began before the messages were taken";
  EXPECT_EQ(held.worker.latest()->deformed.cols(), 16);
  EXPECT_EQ(held.worker.latest()->handles[1].target, Vec2(9, 9));
  EXPECT_EQ(held.worker.status().error, "");
  std::lock_guard lock(held.mutex);
  EXPECT_EQ(held.energy, find_density("arap"));
  EXPECT_EQ(held.parameters.alpha, 77);
}

TEST(WorkerInbox, TheNewestOfAKindReplacesTheOthers) {
  NotingWorker held;
  ASSERT_TRUE(held.runs(test::small_problem()));
  Parameters parameters;
  for (int k = 1; k <= 5; ++k) {
    parameters.alpha = k;
    held.worker.set_parameters(find_density("arap"), parameters);
    held.worker.set_targets(targets_at(Vec2(2, 2 + 0.1 * k)));
  }
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(held.worker.latest()->handles[1].target, Vec2(2, 2 + 0.1 * 5));
  std::lock_guard lock(held.mutex);
  EXPECT_EQ(held.started, 2);
  EXPECT_EQ(held.parameters.alpha, 5);
}

TEST(WorkerInbox, ALoadShowsItsOwnMeshFirst) {
  HeldWorker held;
  held.script->change = [](MeshPair& mesh, int) { test::displace(mesh, 4, Vec2(0.01, 0)); };
  const std::uint64_t first = held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_TRUE(held.worker.latest()->iteration);
  const std::uint64_t second = held.worker.load(test::small_problem());
  EXPECT_NE(first, second);
  EXPECT_TRUE(held.worker.timeline().entries.empty());
  held.gate.let_through();
  ASSERT_TRUE(takes_up(held.worker, second));
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(held.worker.latest()->generation, second);
  EXPECT_FALSE(held.worker.latest()->iteration);
  EXPECT_EQ(held.worker.latest()->deformed, test::small_problem().mesh.deformed());
}

/// A worker whose iterations are held after their last look at the stop token.
struct LateWorker : HeldWorker {
  LateWorker() {
    script->look = nullptr;
    script->change = [this](MeshPair&, int) { gate.pass(); };
  }
};

TEST(WorkerInbox, AnIterationThatEndsAfterALoadIsNeitherRecordedNorShown) {
  bool was_shown = false;
  LateWorker held;
  held.wake = [&] {
    const auto latest = held.worker.latest();
    if (latest && latest->iteration) was_shown = true;
  };
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.load(test::small_problem());
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_TRUE(held.worker.timeline().entries.empty());
  EXPECT_FALSE(was_shown);
}

TEST(WorkerInbox, AnIterationThatEndsAfterTheTimelineWasClearedIsNotRecorded) {
  LateWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  held.worker.clear_timeline();
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_TRUE(held.worker.timeline().entries.empty());
  EXPECT_EQ(held.worker.latest()->iteration->inner, 1) << "what it reached was not published";
  held.gate.let_through();
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_EQ(recorded(held.worker), (std::vector<int>{2}));
}

}  // namespace
}  // namespace foldless
