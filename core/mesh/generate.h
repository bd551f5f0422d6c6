// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/shape.h"

namespace foldless {

/// How to cut a disk into concentric rings of vertices. The number of triangles follows:
/// #F = 2 #V − 2 − boundary_vertices. Ring k of `rings` needs more than π / acos(1 − 1/k)
/// vertices, else its chords would cut the ring within.
struct DiskOptions {
  int rings = 10;              ///< rings round the centre vertex, the boundary included; ≥ 1
  int boundary_vertices = 42;  ///< vertices of the last ring
  int vertices = 293;          ///< all vertices, the centre and the boundary included
  double radius = 1;           ///< length
};

/// Vertices of each ring from the centre (1) outwards; the rings inside the boundary grow in
/// proportion to their radius. Throws Error when the options contradict each other.
std::vector<int> disk_ring_sizes(const DiskOptions& options);

/// Indices of the vertices of one ring of disk(options), counter-clockwise from the positive
/// x-axis; ring 0 is the centre, ring options.rings the boundary.
std::vector<int> disk_ring(const DiskOptions& options, int ring);

/// A disk about the origin of equally spaced rings, neighbours zipped together along the shorter
/// diagonal. Vertices are numbered ring by ring from the centre. Throws as disk_ring_sizes().
Shape disk(const DiskOptions& options);

/// How the cells of a grid are cut in two.
enum class Diagonal {
  rising,      ///< from lower left to upper right
  falling,     ///< from upper left to lower right
  alternating  ///< rising and falling like a chessboard, symmetric in both axes
};

/// A rectangle [0, width] × [0, height] of columns × rows cells; vertices row by row from below.
struct GridOptions {
  int columns = 10;  ///< ≥ 1
  int rows = 10;     ///< ≥ 1
  double width = 1;  ///< length
  double height = 1;
  Diagonal diagonal = Diagonal::rising;
};

/// The grid of the options; vertex (i, j) has index j (columns + 1) + i. Throws Error on sizes
/// that are not positive.
Shape grid(const GridOptions& options);

/// A straight bar [0, length] × [0, width] of nearly square cells, `cells` of them across, cut
/// like a chessboard. Throws as grid().
Shape bar(double length, double width, int cells);

/// The region between two circles about the origin.
struct AnnulusOptions {
  double inner_radius = 0.4;  ///< length, > 0
  double outer_radius = 1;    ///< length, > inner_radius
  int sectors = 48;           ///< vertices of each circle; ≥ 3
  int layers = 6;             ///< rows of triangles between the circles; ≥ 1
};

/// An annulus of circles with equally many vertices, each turned half a step against the one
/// inside; radii grow geometrically so that triangles keep their shape. Vertices circle by circle
/// from inside. Throws Error on options out of range.
Shape annulus(const AnnulusOptions& options);

}  // namespace foldless
