// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace foldless {
namespace {

constexpr float kFarSquared = 1e20F;

/// The lower envelope of the parabolas (x − q)² + heights[q], q = 0, 1, …
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int length)
      : feet_(static_cast<std::size_t>(length)), starts_(static_cast<std::size_t>(length) + 1) {}

  /// Replaces every height by the envelope there.
  void replace(std::vector<float>& heights) {
    build(heights);
    const std::vector<float> before = heights;
    std::size_t k = 0;
    for (std::size_t x = 0; x < heights.size(); ++x) {
      while (starts_[k + 1] < static_cast<double>(x)) ++k;
      const double away = static_cast<double>(x) - static_cast<double>(feet_[k]);
      heights[x] = static_cast<float>(away * away + before[feet_[k]]);
    }
  }

 private:
  void build(std::span<const float> heights) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::size_t last = 0;
    feet_[0] = 0;
    starts_[0] = -kInfinity;
    starts_[1] = kInfinity;
    for (std::size_t q = 1; q < heights.size(); ++q) {
      double start = meeting(heights, feet_[last], q);
      while (start <= starts_[last]) start = meeting(heights, feet_[--last], q);
      feet_[++last] = q;
      starts_[last] = start;
      starts_[last + 1] = kInfinity;
    }
  }

  /// Where the parabola of `q` gets under that of `p` < `q`.
  static double meeting(std::span<const float> heights, std::size_t p, std::size_t q) {
    const auto a = static_cast<double>(p), b = static_cast<double>(q);
    return ((heights[q] + b * b) - (heights[p] + a * a)) / (2 * (b - a));
  }

  std::vector<std::size_t> feet_;
  std::vector<double> starts_;  ///< parabola k is the lowest from starts_[k] to starts_[k + 1]
};

void replace_columns(ScalarGrid& squares) {
  LowerEnvelope envelope(squares.height);
  std::vector<float> column(static_cast<std::size_t>(squares.height));
  for (int x = 0; x < squares.width; ++x) {
    for (int y = 0; y < squares.height; ++y) column[static_cast<std::size_t>(y)] = squares.at(x, y);
    envelope.replace(column);
    for (int y = 0; y < squares.height; ++y) squares.at(x, y) = column[static_cast<std::size_t>(y)];
  }
}

void replace_rows(ScalarGrid& squares) {
  LowerEnvelope envelope(squares.width);
  std::vector<float> row(static_cast<std::size_t>(squares.width));
  for (int y = 0; y < squares.height; ++y) {
    std::copy_n(&squares.at(0, y), row.size(), row.begin());
    envelope.replace(row);
    std::ranges::copy(row, &squares.at(0, y));
  }
}

}  // namespace

ScalarGrid distance_transform(const ScalarGrid& cells) {
  ScalarGrid distances(cells.width, cells.height);
  std::ranges::transform(cells.values, distances.values.begin(),
                         [](float value) { return value > 0 ? 0 : kFarSquared; });
  replace_columns(distances);
  replace_rows(distances);
  for (float& value : distances.values) value = std::sqrt(value);
  return distances;
}

}  // namespace foldless
