// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.h"

namespace foldless {
namespace {

using std::numbers::pi;

void require(bool condition, const char* sentence) {
  if (!condition) throw Error(sentence);
}

Vec2 polar(double radius, double turns) {
  const double angle = 2 * pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Shape collect(const std::vector<Vec2>& points, const std::vector<Eigen::Vector3i>& triangles) {
  Shape shape;
  shape.rest.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v)
    shape.rest.col(static_cast<Eigen::Index>(v)) = points[v];
  shape.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    shape.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return shape;
}

/// A circle of vertices: index of its first vertex and their number.
struct Ring {
  int first;
  int size;
  int at(int k) const { return first + k % size; }
};

/// Fills the strip between two rings, always along the shorter of the two next diagonals.
void zip(const Ring& inner, const Ring& outer, const std::vector<Vec2>& points,
         std::vector<Eigen::Vector3i>& triangles) {
  const auto distance = [&](int a, int b) { return (points[a] - points[b]).norm(); };
  int i = 0, o = 0;
  while (i < inner.size || o < outer.size) {
    const bool can_step_in = i < inner.size;
    const bool step_out =
        !can_step_in || (o < outer.size && distance(inner.at(i), outer.at(o + 1)) <=
                                               distance(inner.at(i + 1), outer.at(o)));
    if (step_out) {
      triangles.emplace_back(inner.at(i), outer.at(o), outer.at(o + 1));
      ++o;
    } else {
      triangles.emplace_back(inner.at(i), outer.at(o), inner.at(i + 1));
      ++i;
    }
  }
}

void fan(const Ring& ring, std::vector<Eigen::Vector3i>& triangles) {
  for (int k = 0; k < ring.size; ++k) triangles.emplace_back(0, ring.at(k), ring.at(k + 1));
}

bool is_rising(Diagonal diagonal, int i, int j) {
  if (diagonal == Diagonal::alternating) return (i + j) % 2 == 0;
  return diagonal == Diagonal::rising;
}

}  // namespace

std::vector<int> disk_ring_sizes(const DiskOptions& options) {
  require(options.rings >= 1 && options.boundary_vertices >= 3,
          "a disk needs at least 1 ring and 3 boundary vertices");
  const int inside = options.vertices - 1 - options.boundary_vertices;
  require(options.rings == 1 ? inside == 0 : inside >= 3 * (options.rings - 1),
          "a disk needs one centre, its boundary and at least 3 vertices for each ring between");
  std::vector<int> sizes{1};
  // Rounding the running total spreads the remainder evenly and hits the sum exactly.
  const double total = 0.5 * options.rings * (options.rings - 1);
  int used = 0;
  for (int k = 1; k < options.rings; ++k) {
    const int left_over = options.rings - 1 - k;
    const int up_to = static_cast<int>(std::lround(inside * (0.5 * k * (k + 1)) / total));
    sizes.push_back(std::clamp(up_to - used, 3, inside - used - 3 * left_over));
    used += sizes.back();
  }
  sizes.push_back(options.boundary_vertices);
  // The chords of a ring must stay outside the ring within.
  for (int k = 1; k <= options.rings; ++k)
    require(k * std::cos(pi / sizes[k]) > k - 1, "a disk needs more vertices for so many rings");
  return sizes;
}

std::vector<int> disk_ring(const DiskOptions& options, int ring) {
  const std::vector<int> sizes = disk_ring_sizes(options);
  require(ring >= 0 && ring <= options.rings, "the disk has no ring of that number");
  std::vector<int> indices(static_cast<std::size_t>(sizes[ring]));
  std::iota(indices.begin(), indices.end(), std::accumulate(&sizes[0], &sizes[ring], 0));
  return indices;
}

Shape disk(const DiskOptions& options) {
  require(options.radius > 0, "the radius of a disk must be positive");
  const std::vector<int> sizes = disk_ring_sizes(options);
  std::vector<Vec2> points{Vec2::Zero()};
  std::vector<Eigen::Vector3i> triangles;
  Ring inner{0, 1};
  for (int k = 1; k <= options.rings; ++k) {
    const Ring ring{static_cast<int>(points.size()), sizes[k]};
    for (int i = 0; i < ring.size; ++i)
      points.push_back(polar(options.radius * k / options.rings, double(i) / ring.size));
    if (k == 1)
      fan(ring, triangles);
    else
      zip(inner, ring, points, triangles);
    inner = ring;
  }
  return collect(points, triangles);
}

Shape grid(const GridOptions& options) {
  require(options.columns >= 1 && options.rows >= 1, "a grid needs at least 1 column and 1 row");
  require(options.width > 0 && options.height > 0, "the size of a grid must be positive");
  std::vector<Vec2> points;
  for (int j = 0; j <= options.rows; ++j)
    for (int i = 0; i <= options.columns; ++i)
      points.emplace_back(options.width * i / options.columns, options.height * j / options.rows);
  std::vector<Eigen::Vector3i> triangles;
  for (int j = 0; j < options.rows; ++j)
    for (int i = 0; i < options.columns; ++i) {
      const int a = j * (options.columns + 1) + i, b = a + 1;
      const int d = a + options.columns + 1, c = d + 1;
      if (is_rising(options.diagonal, i, j)) {
        triangles.emplace_back(a, b, c);
        triangles.emplace_back(a, c, d);
      } else {
        triangles.emplace_back(a, b, d);
        triangles.emplace_back(b, c, d);
      }
    }
  return collect(points, triangles);
}

Shape bar(double length, double width, int cells) {
  require(length > 0 && width > 0 && cells >= 1, "a bar needs positive sizes and at least 1 cell");
  const int columns = std::max(1, static_cast<int>(std::lround(length / width * cells)));
  return grid({columns, cells, length, width, Diagonal::alternating});
}

Shape annulus(const AnnulusOptions& options) {
  require(options.inner_radius > 0 && options.outer_radius > options.inner_radius,
          "the radii of an annulus must be positive and increasing");
  require(options.sectors >= 3 && options.layers >= 1,
          "an annulus needs at least 3 sectors and 1 layer");
  std::vector<Vec2> points;
  std::vector<Eigen::Vector3i> triangles;
  const double growth = options.outer_radius / options.inner_radius;
  for (int k = 0; k <= options.layers; ++k) {
    const double radius = options.inner_radius * std::pow(growth, double(k) / options.layers);
    const Ring ring{static_cast<int>(points.size()), options.sectors};
    for (int i = 0; i < ring.size; ++i)
      points.push_back(polar(radius, (i + 0.5 * (k % 2)) / ring.size));
    if (k > 0) zip({ring.first - ring.size, ring.size}, ring, points, triangles);
  }
  return collect(points, triangles);
}

}  // namespace foldless
