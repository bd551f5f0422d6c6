// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/gui/look.h"
#include "core/motion/easing.h"

namespace foldless {

/// The curve while one of its ends is pulled.
struct PulledCurve {
  Easing easing;
  Vec2 Easing::*end = &Easing::first;
};

/// Its width, and its height for shares from 0 to 1: as much is left above and below. [design
/// pixels]
inline constexpr float kCurveWidth = 180, kCurveHeight = 90;

/// The share of the way over the share of the time, with the two control points as ends that are
/// pulled with the mouse; the nearer one follows. Returns the curve when it is let go.
std::optional<Easing> draw_easing_curve(const Easing& easing, std::optional<PulledCurve>& pulled,
                                        const Look& look);

}  // namespace foldless
