// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace foldless {
namespace {

TEST(Team, RunsEveryTaskOnceHoweverManyAndHoweverOften) {
  for (const int threads : {1, 2, 5}) {
    SCOPED_TRACE(threads);
    Team team(threads);
    EXPECT_EQ(team.size(), threads);
    for (int round = 0; round < 3000; ++round) {
      const int count = round % 23;
      std::vector<int> times(23, 0);  // each is written by one task
      team.run(count, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
      ASSERT_EQ(std::accumulate(times.begin(), times.end(), 0), count);
      for (int i = 0; i < count; ++i) ASSERT_EQ(times[static_cast<std::size_t>(i)], 1);
    }
  }
}

TEST(Team, HelpersTakePart) {
  Team team(2);
  std::atomic<int> at_once = 0;
  std::atomic<bool> met = false;
  // Neither task ends before the other has begun.
  team.run(2, [&](int) {
    if (++at_once == 2) met = true;
    while (!met) std::this_thread::yield();
  });
  EXPECT_TRUE(met);
}

/// The tasks of a job of four that the asking thread ran, in their order, where all that came
/// before `last` were done before that one ended.
std::vector<int> tasks_of_asking_thread(Team& team, int last) {
  const std::thread::id asking = std::this_thread::get_id();
  std::vector<int> own;
  std::atomic<int> begun = 0, others_done = 0;
  team.run(4, [&](int i) {
    if (std::this_thread::get_id() == asking) own.push_back(i);
    ++begun;
    while (begun < 2) std::this_thread::yield();  // so that both threads have one
    while (i == last && others_done < 3) std::this_thread::yield();
    if (i != last) ++others_done;
  });
  return own;
}

TEST(Team, EachThreadBeginsWithItsShareAndThenTakesTasksOfOthers) {
  Team team(2);
  for (int round = 0; round < 100; ++round) {
    ASSERT_EQ(tasks_of_asking_thread(team, 2), (std::vector{0, 1, 3}))
        << "the helper has the third";
    ASSERT_EQ(tasks_of_asking_thread(team, 0), std::vector{0}) << "the helper has all others";
  }
}

TEST(Team, WhatATaskThrowsArrivesWhenTheOthersAreDone) {
  Team team(3);
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> done = 0;
    const auto run = [&] {
      team.run(40, [&](int i) {
        if (i == round % 40) throw std::runtime_error("of a task");
        ++done;
      });
    };
    EXPECT_THROW(run(), std::runtime_error);
    EXPECT_EQ(done, 39);
  }
  int after = 0;
  team.run(1, [&](int) { ++after; });
  EXPECT_EQ(after, 1);
}

TEST(Team, IsAskedWhereItIsPresentAndByNoTask) {
  EXPECT_EQ(present_team(), nullptr);
  Team alone(1);
  EXPECT_EQ((WithTeam(&alone), present_team()), nullptr);
  Team team(2);
  {
    const WithTeam with(&team);
    EXPECT_EQ(present_team(), &team);
    std::atomic<int> with_a_team = 0;
    in_parallel(50, [&](int) { with_a_team += present_team() != nullptr; });
    EXPECT_EQ(with_a_team, 0);
    EXPECT_EQ(present_team(), &team);
  }
  EXPECT_EQ(present_team(), nullptr);
}

TEST(Team, RangesMakeUpTheWhole) {
  Team team(2);
  for (const bool is_present : {false, true}) {
    const WithTeam with(is_present ? &team : nullptr);
    for (const std::ptrdiff_t count : {0, 1, 7, 8, 9, 100}) {
      std::vector<int> times(100, 0);
      std::atomic<int> ranges = 0;
      in_ranges(count, 8, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        ++ranges;
        for (std::ptrdiff_t i = begin; i < end; ++i) ++times[static_cast<std::size_t>(i)];
      });
      EXPECT_EQ(ranges, is_present ? (count + 7) / 8 : count > 0);
      for (std::ptrdiff_t i = 0; i < 100; ++i)
        EXPECT_EQ(times[static_cast<std::size_t>(i)], i < count);
    }
  }
}

}  // namespace
}  // namespace foldless
