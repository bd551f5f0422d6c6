// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// A planar triangle mesh at rest, as generators make it: every triangle counter-clockwise.
struct Shape {
  Triangles triangles;  ///< 3 × #F
  Points rest;          ///< 2 × #V
};

/// Adds vertices and triangles after those that are there.
void append(const Shape& part, Shape& whole);

}  // namespace foldless
