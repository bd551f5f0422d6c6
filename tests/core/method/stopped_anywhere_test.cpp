// SPDX-License-Identifier: GPL-3.0-or-later
// A stop that comes in the middle of a step, at whichever moment, costs that step and no more.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "core/method/methods.h"
#include "tests/core/method/method_fixture.h"

namespace foldless {
namespace {

/// A step whose token is set by another thread some time after it has begun.
std::optional<Iteration> step_that_is_stopped_after(std::chrono::microseconds time,
                                                    Method& method) {
  std::stop_source stop;
  const std::jthread later([&] {
    std::this_thread::sleep_for(time);
    stop.request_stop();
  });
  return method.step(stop.get_token());
}

TEST(StoppedAnywhere, ARunGoesOnAsIfItHadNotBeenStopped) {
  std::mt19937 random(7);
  for (const MethodRow& row : methods()) {
    SCOPED_TRACE(row.name);
    Problem problem = test::turned_disk({.degrees = 60});
    problem.parameters.method = row.name;
    problem.parameters.distortion_bound = 60;
    const auto method = row.start(problem), undisturbed = row.start(problem);
    int stopped = 0;
    for (int step = 0; step < 40 && !method->outcome(); ++step) {
      const bool has_record =
          step_that_is_stopped_after(std::chrono::microseconds(random() % 300), *method) ||
          method->outcome();
      stopped += !has_record;
      if (!has_record && !method->step({})) {
        ASSERT_TRUE(method->outcome());
      }
      undisturbed->step({});
      ASSERT_EQ(method->mesh().triangles(), undisturbed->mesh().triangles()) << step;
      ASSERT_EQ(method->mesh().deformed(), undisturbed->mesh().deformed()) << step;
    }
    EXPECT_EQ(method->outcome(), undisturbed->outcome());
    RecordProperty(std::string(row.name), stopped);
    std::cout << row.name << ": " << stopped << " steps were stopped\n";
  }
}

}  // namespace
}  // namespace foldless
