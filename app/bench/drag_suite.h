// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/bench/bench_scene.h"

namespace foldless {

/// Drags as a hand makes them: one handle goes along a curve of straight legs, bends and reversals,
/// 1 % of the rest diagonal D a frame, while others hold the mesh. The middle of a square, and the
/// end of a bar, of 512, 5,000, 49,928 and 500,000 triangles each, in turn. The same on every
/// machine.
inline constexpr int kDragScenes = 8;
BenchScene drag_scene(int index);

/// Where a handle is after each frame that starts at `from` in direction `heading` [rad], `stride`
/// [length] a frame.
std::vector<Vec2> drag_curve(const Vec2& from, double heading, double stride);

}  // namespace foldless
