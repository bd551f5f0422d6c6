// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

namespace foldless {

/// The same on every machine, unlike distributions of the standard library.
class ConstructionRandom {
 public:
  explicit ConstructionRandom(std::uint64_t seed) : numbers_(seed) {}

  /// From 0 to less than 1.
  double uniform() { return static_cast<double>(numbers_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 numbers_;
};

}  // namespace foldless
