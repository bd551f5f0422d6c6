// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/run/gate.h"
#include "tests/core/run/worker_fixture.h"

namespace foldless::test {

/// A problem whose iterations take no time to speak of.
inline Problem small_problem() { return grid_problem(3, Vec2(2, 2)); }

/// A worker whose every iteration is held at a gate before it looks at the stop token: a message
/// that cancels, posted meanwhile, is certain to cancel it.
struct HeldWorker {
  HeldWorker() {
    script->look = [this](const std::stop_token&) { gate.pass(); };
  }
  HeldWorker(const HeldWorker&) = delete;
  HeldWorker& operator=(const HeldWorker&) = delete;
  ~HeldWorker() { gate.open(); }

  Gate gate;
  std::shared_ptr<Script> script = std::make_shared<Script>();
  std::function<void()> wake;  ///< set it before the first load
  Worker worker{[this] {
                  if (wake) wake();
                },
                {.start = starter_of(script)}};
};

/// The `inner` of every record on the timeline.
inline std::vector<int> recorded(const Worker& worker) {
  std::vector<int> numbers;
  for (const TimelineEntry& entry : worker.timeline().entries)
    numbers.push_back(entry.record.inner);
  return numbers;
}

/// True when no message waits to be taken up any more.
inline bool takes_up_all(const Worker& worker) {
  return eventually([&] { return worker.status().is_current; });
}

}  // namespace foldless::test
