// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/stop_watch.h"

#include <pthread.h>

#include <chrono>
#include <ctime>
#include <utility>

namespace foldless {

clockid_t own_clock() {
  clockid_t clock{};
  pthread_getcpuclockid(pthread_self(), &clock);
  return clock;
}

double seconds_on(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

StopWatch::StopWatch(StopConditions conditions) : conditions_(std::move(conditions)) {
  if (conditions_.time_limit) *conditions_.time_limit += seconds_on(own_clock());
  thread_ = std::jthread(
      [this, clock = own_clock()](const std::stop_token& ending) { watch(ending, clock); });
}

void StopWatch::watch(const std::stop_token& ending, clockid_t clock) {
  std::unique_lock lock(mutex_);
  while (!ending.stop_requested() && !stop_.stop_requested()) {
    if (conditions_.time_limit && seconds_on(clock) > *conditions_.time_limit) {
      is_time_over_ = true;
      stop_.request_stop();
    }
    if (conditions_.is_interrupted && conditions_.is_interrupted()) stop_.request_stop();
    pause_.wait_for(lock, ending, std::chrono::milliseconds(10), [] { return false; });
  }
}

}  // namespace foldless
