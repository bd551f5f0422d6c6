// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/check.h>
#include <foldless/session.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/core/api/api_fixture.h"

namespace foldless {
namespace {

using test::session_of;
using test::Task;

bool is_valid(const Result& result) {
  return check(result.rest, result.triangles, result.deformed).is_injective();
}

TEST(Session, StandsAtRestBeforeItsFirstStep) {
  const Task task = test::pulled_square(6);
  const Session session = session_of(task);
  EXPECT_EQ(session.deformed(), task.rest);
  EXPECT_FALSE(session.is_reached());
  EXPECT_FALSE(session.has_ended());
  EXPECT_FALSE(session.result().outcome);
}

TEST(Session, StepsToWhereSolveGoes) {
  const Task task = test::swapped_square(8);
  Session session = session_of(task);
  int steps = 0;
  while (session.step()) {
    ++steps;
    ASSERT_TRUE(is_valid(session.result()));
  }
  EXPECT_TRUE(session.has_ended());
  const Result whole = test::solved(task);
  EXPECT_EQ(session.deformed(), whole.deformed);
  EXPECT_EQ(session.result().triangles, whole.triangles);
  EXPECT_EQ(whole.log.size(), static_cast<std::size_t>(steps));
}

TEST(Session, GoesOnWhenTargetsMove) {
  Task task = test::pulled_square(6);
  Session session = session_of(task);
  EXPECT_TRUE(session.run());
  EXPECT_TRUE(session.is_reached());
  task.targets(1, 0) = 1.5;
  session.set_targets(task.targets);
  EXPECT_FALSE(session.is_reached());
  EXPECT_FALSE(session.has_ended());
  EXPECT_TRUE(session.run());
  EXPECT_TRUE(session.is_reached());
  EXPECT_NEAR(session.deformed()(48, 0), 1.5, 1e-5);
  EXPECT_THROW(session.set_targets(PointMatrix::Zero(1, 2)), Error);
}

TEST(Session, IsCancelledFromAnotherThreadWithAValidMesh) {
  Session session = session_of(test::swapped_square(80));
  std::jthread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    session.cancel();
  });
  const bool is_done = session.run();
  const Result result = session.result();
  EXPECT_TRUE(is_valid(result));
  ASSERT_FALSE(is_done) << "done before it was cancelled: take a larger mesh";
  EXPECT_EQ(result.outcome, Outcome::cancelled);
  EXPECT_FALSE(session.has_ended());
  EXPECT_TRUE(session.step()) << "a cancelled run goes on";
}

TEST(Session, TakesACancellationBeforeItsRunForThatRun) {
  Session session = session_of(test::pulled_square(6));
  session.cancel();
  EXPECT_FALSE(session.run());
  EXPECT_EQ(session.result().outcome, Outcome::cancelled);
  EXPECT_TRUE(session.run());
  EXPECT_TRUE(session.is_reached());
}

TEST(Session, TellsItsMeshWhileAnotherThreadRunsIt) {
  Session session = session_of(test::swapped_square(24));
  std::jthread other([&] { session.run(); });
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(is_valid(session.result()));
  session.cancel();
}

TEST(Session, OnItsThreadKnowsNothingOfOthers) {
  const Task task = test::swapped_square(12);
  const Result alone = test::solved(task);
  std::array<Result, 2> results;
  {
    std::jthread first([&] { results[0] = test::solved(task); });
    std::jthread second([&] { results[1] = test::solved(task); });
  }
  for (const Result& result : results) {
    EXPECT_EQ(result.deformed, alone.deformed);
    EXPECT_EQ(result.triangles, alone.triangles);
  }
}

}  // namespace
}  // namespace foldless
