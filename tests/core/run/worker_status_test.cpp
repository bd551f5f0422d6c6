// SPDX-License-Identifier: GPL-3.0-or-later
// What the worker tells of itself, and when it wakes its reader.
#include <gtest/gtest.h>

#include <mutex>

#include "tests/core/run/held_worker.h"

namespace foldless {
namespace {

using test::eventually;
using test::HeldWorker;
using test::reaches;
using test::ScriptedWorker;
using test::takes_up_all;
using test::targets_at;

/// What could be read at each wake.
struct Wakes {
  struct Wake {
    WorkerStatus status;
    std::size_t iterations;
    int newest;  ///< `inner` of the newest snapshot, 0 before the first iteration
  };

  void note(const Worker& worker) {
    const auto latest = worker.latest();
    std::lock_guard lock(mutex);
    wakes.push_back({worker.status(), worker.timeline().entries.size(),
                     latest && latest->iteration ? latest->iteration->inner : 0});
  }
  std::vector<Wake> so_far() {
    std::lock_guard lock(mutex);
    return wakes;
  }
  std::mutex mutex;
  std::vector<Wake> wakes;
};

TEST(WorkerStatus, TheReaderIsWokenWhenItCanReadWhatIsNew) {
  Wakes wakes;
  HeldWorker held;
  held.gate.open();
  held.script->length = 3;
  held.wake = [&] { wakes.note(held.worker); };
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(reaches(held.worker, WorkerState::finished));
  ASSERT_TRUE(eventually([&] {
    const auto seen = wakes.so_far();
    return !seen.empty() && seen.back().status.state == WorkerState::finished;
  }));
  std::vector<std::size_t> counts;
  for (const Wakes::Wake& wake : wakes.so_far()) {
    EXPECT_EQ(wake.newest, static_cast<int>(wake.iterations));
    if (wake.iterations > 0) counts.push_back(wake.iterations);
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2, 3})) << "one wake an iteration";
}

TEST(WorkerStatus, SaysWhetherAMessageWaits) {
  Wakes wakes;
  HeldWorker held;
  held.wake = [&] { wakes.note(held.worker); };
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  EXPECT_TRUE(held.worker.status().is_current);
  const std::size_t before = wakes.so_far().size();
  held.worker.set_mode(WorkerMode::paused);
  EXPECT_FALSE(held.worker.status().is_current);
  held.gate.let_through();
  ASSERT_TRUE(eventually([&] { return wakes.so_far().size() == before + 2; }));
  // The iteration ended, then the message was taken up.
  EXPECT_FALSE(wakes.so_far()[before].status.is_current);
  EXPECT_EQ(wakes.so_far()[before].status.state, WorkerState::running);
  EXPECT_TRUE(wakes.so_far()[before + 1].status.is_current);
  EXPECT_EQ(wakes.so_far()[before + 1].status.state, WorkerState::paused);
}

TEST(WorkerStatus, APaceThatComesAloneIsTakenUp) {
  ScriptedWorker scripted;
  scripted.worker.load(test::small_problem());
  ASSERT_TRUE(takes_up_all(scripted.worker));
  scripted.worker.set_pace(5);
  EXPECT_TRUE(takes_up_all(scripted.worker));
}

TEST(WorkerStatus, TheVerdictComesWithTheOutcome) {
  HeldWorker held;
  held.script->length = 2;
  held.script->verdict = "the two of them cannot both be had";
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  for (int k = 0; k < 2; ++k) {
    ASSERT_TRUE(held.gate.holds_the_solver());
    EXPECT_EQ(held.worker.status().verdict, "");
    EXPECT_FALSE(held.worker.status().outcome);
    held.gate.let_through();
  }
  ASSERT_TRUE(reaches(held.worker, WorkerState::finished));
  EXPECT_EQ(held.worker.status().outcome, Outcome::gradient);
  EXPECT_EQ(held.worker.status().verdict, held.script->verdict);
}

TEST(WorkerStatus, IsSatisfiedWhereTheHandlesAreAtTheirTargets) {
  ScriptedWorker scripted;
  scripted.worker.load(test::small_problem());
  ASSERT_TRUE(takes_up_all(scripted.worker));
  EXPECT_TRUE(scripted.worker.status().satisfied);
  scripted.worker.set_targets(targets_at(Vec2(2, 2.1)));
  ASSERT_TRUE(takes_up_all(scripted.worker));
  EXPECT_FALSE(scripted.worker.status().satisfied);
}

TEST(WorkerStatus, AProblemThatIsRefusedEndsTheRunBeforeIt) {
  HeldWorker held;
  held.worker.load(test::small_problem());
  held.worker.set_mode(WorkerMode::running);
  ASSERT_TRUE(held.gate.holds_the_solver());
  Problem folded = test::small_problem();
  test::displace(folded.mesh, 4, Vec2(5, 5));
  held.worker.load(folded);
  held.gate.let_through();
  ASSERT_TRUE(takes_up_all(held.worker));
  EXPECT_NE(held.worker.status().error, "");
  EXPECT_EQ(held.worker.status().state, WorkerState::idle);
  EXPECT_TRUE(test::is_valid(*held.worker.latest()));
  // Targets have no run to go to.
  held.worker.set_targets(targets_at(Vec2(2, 3)));
  ASSERT_TRUE(takes_up_all(held.worker));
  EXPECT_EQ(held.worker.latest()->handles, test::small_problem().handles);
  EXPECT_EQ(held.script->begun, 1);
}

}  // namespace
}  // namespace foldless
