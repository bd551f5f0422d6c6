// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/method/steps.h"

namespace foldless::test {

/// Drives the steps of a stage by themselves, as SteppedMethod drives those of a method.
template <typename T>
class StageRunner {
 public:
  explicit StageRunner(Steps<T> steps) : steps_(std::move(steps)) { steps_.begin(context_); }
  StageRunner(const StageRunner&) = delete;
  StageRunner& operator=(const StageRunner&) = delete;

  bool has_ended() const { return steps_.have_ended(); }
  /// On to the next record; nothing where there is none, or where the token was set.
  std::optional<Iteration> step(const std::stop_token& token = {}) {
    context_.record.reset();
    while (!has_ended() && !context_.record && context_.request->make(token))
      context_.waiting.resume();
    if (context_.record) records_.push_back(*context_.record);
    return context_.record;
  }
  /// To the end, or for so many records; true when it has ended.
  bool run(int most_records = 100'000) {
    for (int i = 0; i < most_records && !has_ended(); ++i) step();
    return has_ended();
  }
  /// Precondition: it has ended.
  T result() { return steps_.result(); }

  const std::vector<Iteration>& records() const { return records_; }

 private:
  StepContext context_;
  Steps<T> steps_;
  std::vector<Iteration> records_;
};

/// Runs a stage to its end, a fourth of its updates cancelled at random. Calls after(was_cancelled)
/// after every one and returns how many were.
template <typename T, typename After>
int run_with_cancels(StageRunner<T>& runner, std::uint64_t seed, const After& after) {
  std::mt19937_64 random(seed);
  std::stop_source stopped;
  stopped.request_stop();
  int cancelled = 0;
  while (!runner.has_ended()) {
    const bool stops = random() % 4 == 0;
    const bool was_cancelled = !runner.step(stops ? stopped.get_token() : std::stop_token());
    cancelled += was_cancelled;
    after(was_cancelled);
  }
  return cancelled;
}

/// The result of a stage that runs to its end.
template <typename T>
T run_to_the_end(Steps<T> steps) {
  StageRunner<T> runner(std::move(steps));
  runner.run();
  return runner.result();
}

}  // namespace foldless::test
