// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace foldless {

/// SplitMix64: the same numbers from the same seed on every machine and with every compiler.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  /// In [0, count), count > 0. The bias of the remainder is far below what a suite could show.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  /// An integer in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1));
  }
  /// −1 or 1.
  double sign() { return next() % 2 == 0 ? -1 : 1; }

 private:
  std::uint64_t state_;
};

}  // namespace foldless
