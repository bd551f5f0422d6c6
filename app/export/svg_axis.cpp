// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/svg_axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace foldless {
namespace {

/// The shortest of six digits, whatever the locale.
std::string short_text(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
}

/// 1, 2 or 5 times a power of ten: the smallest that is not below `least`.
double round_step(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least * (1 - 1e-9)) return factor * decade;
  return 10 * decade;
}

}  // namespace

AxisScale::AxisScale(const std::vector<double>& values, bool is_logarithmic)
    : is_logarithmic_(is_logarithmic) {
  bool is_empty = true;
  for (const double value : values) {
    if (!holds(value)) continue;
    const double at = position(value);
    low_ = is_empty ? at : std::min(low_, at);
    high_ = is_empty ? at : std::max(high_, at);
    is_empty = false;
  }
  if (is_logarithmic_) {
    low_ = std::floor(low_);
    high_ = std::ceil(high_);
  }
  // A single value: some room above it, enough to tell the ends apart whatever its size.
  if (!(high_ > low_)) high_ = low_ + (is_logarithmic_ ? 1 : std::max(1.0, std::abs(low_)));
}

bool AxisScale::holds(double value) const {
  return std::isfinite(value) && (!is_logarithmic_ || value > 0);
}

double AxisScale::position(double value) const {
  return is_logarithmic_ ? std::log10(value) : value;
}

double AxisScale::fraction(double value) const { return (position(value) - low_) / (high_ - low_); }

std::vector<Tick> AxisScale::ticks() const {
  return is_logarithmic_ ? decade_ticks() : linear_ticks();
}

std::vector<Tick> AxisScale::linear_ticks() const {
  const double step = round_step((high_ - low_) / 7);
  std::vector<Tick> ticks;
  const auto first = std::ceil(low_ / step - 1e-9);
  for (double k = first; k * step <= high_ + 1e-9 * step; ++k)
    ticks.push_back({k * step + 0.0, short_text(k * step + 0.0), ""});  // no minus zero
  return ticks;
}

std::vector<Tick> AxisScale::decade_ticks() const {
  const int low = static_cast<int>(low_);
  const int high = static_cast<int>(high_);
  const int step = (high - low + 7) / 8;
  std::vector<Tick> ticks;
  for (int exponent = low; exponent <= high; exponent += step)
    ticks.push_back({std::pow(10, exponent), "10", std::to_string(exponent)});
  return ticks;
}

}  // namespace foldless
