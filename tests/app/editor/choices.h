// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace foldless::test {

/// Random numbers from a seed, after those that somebody has said.
class Choices {
 public:
  using result_type = std::uint32_t;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  void seed(unsigned seed) {
    random_.seed(seed);
    said_.clear();
  }
  /// A byte is a number, the highest of its four.
  void say(std::span<const std::uint8_t> bytes) { said_.assign(bytes.rbegin(), bytes.rend()); }
  bool has_said_all() const { return said_.empty(); }

  result_type operator()() {
    if (said_.empty()) return static_cast<result_type>(random_());
    const result_type high = said_.back();
    said_.pop_back();
    return high << 24 | static_cast<result_type>(random_() >> 8 & 0xffffff);
  }

 private:
  std::mt19937 random_;
  std::vector<std::uint8_t> said_;  ///< the next one last
};

}  // namespace foldless::test
