// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

#include "core/mesh/injective.h"
#include "core/run/worker.h"
#include "tests/core/run/scripted_method.h"
#include "tests/support/patience.h"

namespace foldless::test {

using namespace std::chrono_literals;

/// Waits until the condition holds; false when it never does.
template <typename Condition>
bool eventually(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(200us);
  }
  return true;
}

inline bool reaches(const Worker& worker, WorkerState state) {
  return eventually([&] { return worker.status().state == state; });
}

/// True when the worker has taken up the load of that generation.
inline bool takes_up(const Worker& worker, std::uint64_t generation) {
  return eventually([&] { return worker.status().generation == generation; });
}

inline bool is_valid(const Snapshot& s) { return is_injective(*s.triangles, *s.rest, s.deformed); }

/// Targets of the two handles of grid_problem().
inline Points targets_at(const Vec2& target) {
  Points targets = Points::Zero(2, 2);
  targets.col(1) = target;
  return targets;
}

/// A worker whose method follows a script.
struct ScriptedWorker {
  std::shared_ptr<Script> script = std::make_shared<Script>();
  Worker worker{{}, {.start = starter_of(script)}};
};

}  // namespace foldless::test
