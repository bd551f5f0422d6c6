// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The last stage: settles, and where splits left vertices that nobody needs, collapses them and
/// settles again, as long as E Kᵉ stays about what it was. What raised it too much is undone.
/// Where a triangle is still crushed then, it settles once more with a larger exponent.
Steps<> tidy(Workspace& work);

/// The largest σ₁/σ₂ of all triangles.
double largest_distortion(const MeshPair& mesh);
/// Up to this largest σ₁/σ₂ no stage looks for a better shape: it seldom finds any.
inline constexpr double kHardlyDistorted = 20;
/// A triangle of this σ₁/σ₂ counts as crushed.
inline constexpr double kCrushed = 1e3;
bool is_crushed(const MeshPair& mesh);

}  // namespace foldless
