// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace foldless::test {

/// How long a test waits for what has to come. It ends a test that waits in vain and is no measure
/// of speed: other work may make the machine many times slower.
inline constexpr std::chrono::seconds kPatience{120};

/// Waits until a condition holds; false when it never does.
template <typename Condition>
bool comes_true(const Condition& condition) {
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return true;
}

}  // namespace foldless::test
