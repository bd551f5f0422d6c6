// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/stop_watch.h"

#include <gtest/gtest.h>

#include <chrono>

namespace foldless {
namespace {

/// Works until the token is set or this thread has worked for so many seconds.
void work_under(const std::stop_token& token, double most) {
  const double start = seconds_on(own_clock());
  while (!token.stop_requested() && seconds_on(own_clock()) - start < most) {
  }
}

TEST(StopWatch, StopsWhenTheProcessorTimeIsOver) {
  const double start = seconds_on(own_clock());
  const StopWatch watch({.time_limit = 0.2, .is_interrupted = {}});
  work_under(watch.token(), 60);
  const double seconds = seconds_on(own_clock()) - start;
  EXPECT_TRUE(watch.is_time_over());
  EXPECT_GE(seconds, 0.2) << "counted from before the watch was made";
  EXPECT_LT(seconds, 30);
}

TEST(StopWatch, DoesNotCountTheTimeOfSleep) {
  const StopWatch watch({.time_limit = 30, .is_interrupted = {}});
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_FALSE(watch.token().stop_requested());
}

TEST(StopWatch, StopsWhenItIsInterrupted) {
  std::atomic<bool> is_interrupted = false;
  const StopWatch watch(
      {.time_limit = {}, .is_interrupted = [&] { return is_interrupted.load(); }});
  work_under(watch.token(), 0.05);
  EXPECT_FALSE(watch.token().stop_requested());
  is_interrupted = true;
  work_under(watch.token(), 60);
  EXPECT_TRUE(watch.token().stop_requested());
  EXPECT_FALSE(watch.is_time_over());
}

}  // namespace
}  // namespace foldless
