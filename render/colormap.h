// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace foldless {

/// The perceptually uniform map from dark violet (0) over green to yellow (1), safe for
/// colour-blind eyes: within 0.01 of matplotlib's "viridis". t is clamped to [0, 1]. sRGB in [0,
/// 1].
glm::vec3 viridis(float t);

}  // namespace foldless
