// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/easing.h"

#include <algorithm>
#include <array>

namespace foldless {
namespace {

/// The Bézier curve with the ends 0 and 1.
double bezier(double first, double second, double s) {
  return ((1 + 3 * first - 3 * second) * s + 3 * second - 6 * first) * s * s + 3 * first * s;
}

}  // namespace

double Easing::at(double time) const {
  if (time <= 0) return 0;
  if (time >= 1) return 1;
  if (is_held) return 0;
  if (first == Vec2(0, 0) && second == Vec2(1, 1)) return time;
  // x(s) ascends, since its control points are in [0, 1].
  double low = 0, high = 1;
  constexpr int kBitsOfADouble = 53;
  for (int i = 0; i < kBitsOfADouble; ++i) {
    const double middle = 0.5 * (low + high);
    (bezier(first.x(), second.x(), middle) < time ? low : high) = middle;
  }
  return bezier(first.y(), second.y(), high);
}

std::span<const NamedEasing> easings() {
  static const std::array rows{
      NamedEasing{"linear", {}},
      NamedEasing{"hold", {{0, 0}, {1, 1}, true}},
      NamedEasing{"in", {{0.42, 0}, {1, 1}}},
      NamedEasing{"out", {{0, 0}, {0.58, 1}}},
      NamedEasing{"both", {{0.42, 0}, {0.58, 1}}},
  };
  return rows;
}

std::optional<Easing> find_easing(std::string_view name) {
  const auto row = std::ranges::find(easings(), name, &NamedEasing::name);
  return row == easings().end() ? std::nullopt : std::optional(row->easing);
}

std::string_view name_of(const Easing& easing) {
  const auto row = std::ranges::find(easings(), easing, &NamedEasing::easing);
  return row == easings().end() ? std::string_view() : row->name;
}

}  // namespace foldless
