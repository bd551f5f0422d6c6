// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/mesh/triangle.h"

namespace foldless {

/// How a value goes from one key to the next: the share of the way over the share of the time, a
/// cubic Bézier curve from (0, 0) to (1, 1), as cubic-bezier() of [CSS Easing Functions]. Linear
/// when it is left as it is.
struct Easing {
  Vec2 first{0, 0}, second{1, 1};  ///< control points, x in [0, 1]
  bool is_held = false;            ///< the value stays until the next key

  bool operator==(const Easing&) const = default;

  /// The share of the way at a share of the time, in [0, 1]; below 0 and above 1 where control
  /// points are.
  double at(double time) const;
};

struct NamedEasing {
  std::string_view name;
  Easing easing;
};

/// linear, hold, in, out and both.
std::span<const NamedEasing> easings();
std::optional<Easing> find_easing(std::string_view name);
/// Empty for a curve that has none.
std::string_view name_of(const Easing& easing);

}  // namespace foldless
