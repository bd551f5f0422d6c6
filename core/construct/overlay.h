// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Where a chord of one triangulation of a polygon crosses one of another.
struct ChordCrossing {
  /// One of the two chords, from its smaller corner, and the crossing on it.
  struct Place {
    Edge chord;
    double t;  ///< 0 < t < 1; crossings divide a chord in equal parts
  };
  Place first, second;
};

/// Two triangulations of one polygon of n corners laid over each other, as in a strictly convex
/// polygon with straight chords. Which corner is where does not matter, nor where on a chord its
/// crossings are, for only their order does.
struct Overlay {
  std::vector<ChordCrossing> crossings;  ///< vertices n, n + 1, …; 0 … n − 1 are the corners
  /// The vertices of each, counter-clockwise. A face is the intersection of a triangle of one
  /// triangulation with one of the other: convex, and without a straight angle.
  std::vector<std::vector<int>> faces;
};

/// Precondition: triangulations of a polygon of so many corners, triangles i < j < k. O(n²).
Overlay overlay_of(int corners, const Triangles& first, const Triangles& second);

/// How many of some chords {i, j}, i < j, a chord crosses.
int crossings_of(const Edge& chord, const std::vector<Edge>& chords);
/// Sides of triangles i < j < k that are no sides of a polygon of so many corners, each once.
std::vector<Edge> chords_of(int corners, const Triangles& triangles);

}  // namespace foldless
