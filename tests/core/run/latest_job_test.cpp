// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/latest_job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>

namespace foldless {
namespace {

TEST(LatestJob, RunsAJobOnAThreadOfItsOwn) {
  std::latch ran(1);
  std::thread::id thread;
  LatestJob jobs;
  jobs.start([&](const std::stop_token&) {
    thread = std::this_thread::get_id();
    ran.count_down();
  });
  ran.wait();
  EXPECT_NE(thread, std::this_thread::get_id());
}

TEST(LatestJob, TheNewestStopsTheRunningOneAndReplacesThoseThatWait) {
  std::latch began(1), ended(1);
  std::atomic<int> skipped = 0;
  std::atomic<bool> was_stopped = false;
  LatestJob jobs;
  jobs.start([&](const std::stop_token& stop) {
    began.count_down();
    while (!stop.stop_requested()) std::this_thread::yield();
    was_stopped = true;
    // Those that wait are replaced meanwhile.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  });
  began.wait();
  for (int k = 0; k < 5; ++k) jobs.start([&](const std::stop_token&) { ++skipped; });
  jobs.start([&](const std::stop_token& stop) {
    EXPECT_FALSE(stop.stop_requested());
    ended.count_down();
  });
  ended.wait();
  EXPECT_TRUE(was_stopped);
  EXPECT_EQ(skipped, 0);
}

TEST(LatestJob, ACancelledJobIsAskedToStopAndTheNextOneRuns) {
  std::latch began(1), stopped(1), next(1);
  LatestJob jobs;
  jobs.start([&](const std::stop_token& stop) {
    began.count_down();
    while (!stop.stop_requested()) std::this_thread::yield();
    stopped.count_down();
  });
  began.wait();
  jobs.cancel();
  stopped.wait();
  jobs.start([&](const std::stop_token& stop) {
    EXPECT_FALSE(stop.stop_requested());
    next.count_down();
  });
  next.wait();
}

TEST(LatestJob, EndsWithAJobThatRuns) {
  std::latch began(1);
  std::atomic<bool> was_stopped = false;
  {
    LatestJob jobs;
    jobs.start([&](const std::stop_token& stop) {
      began.count_down();
      while (!stop.stop_requested()) std::this_thread::yield();
      was_stopped = true;
    });
    began.wait();
  }
  EXPECT_TRUE(was_stopped);
}

}  // namespace
}  // namespace foldless
