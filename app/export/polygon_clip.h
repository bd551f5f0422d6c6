// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "render/camera.h"

namespace foldless {

/// Its corners in order, closed.
using Polygon = std::vector<glm::dvec2>;

/// The part of a polygon inside a box, by the cuts of Sutherland and Hodgman. Where the polygon is
/// not convex, parts are joined by edges along the box. Empty where there is none.
Polygon clipped(Polygon polygon, const Box& box);

/// The part of the line from a to b inside a box.
std::optional<std::pair<glm::dvec2, glm::dvec2>> clipped_line(glm::dvec2 a, glm::dvec2 b,
                                                              const Box& box);

/// Whether the box round these points meets a box.
bool may_meet(const Polygon& polygon, const Box& box);

}  // namespace foldless
