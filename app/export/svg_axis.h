// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace foldless {

/// A place on an axis that has a number.
struct Tick {
  double value;
  std::string text;      ///< `0.5`, or the base of a power, `10`
  std::string exponent;  ///< of a power of ten; empty on linear axes
};

/// The range of an axis, and where its numbers are. Linear ranges end at the data, logarithmic ones
/// at powers of ten.
class AxisScale {
 public:
  /// An axis that holds all values which can be on it; [0, 1] or [1, 10] when none can.
  AxisScale(const std::vector<double>& values, bool is_logarithmic);

  /// False for what is not finite, and on a logarithmic axis for what is not positive.
  bool holds(double value) const;
  /// Where a value is: 0 at the low end, 1 at the high end. Precondition: holds(value).
  double fraction(double value) const;
  /// About five to eight of them, from low to high.
  std::vector<Tick> ticks() const;

 private:
  double position(double value) const;
  std::vector<Tick> linear_ticks() const;
  std::vector<Tick> decade_ticks() const;

  bool is_logarithmic_;
  double low_ = 0;  ///< logarithmic axes: the exponent of ten
  double high_ = 1;
};

}  // namespace foldless
