// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/hard_suite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "app/bench/hard_polygons.h"
#include "app/bench/plane_map.h"
#include "app/bench/random_mesh.h"
#include "core/energy/densities.h"
#include "core/mesh/boundary.h"
#include "core/mesh/generate.h"

namespace foldless {
namespace {

using Polygon = Points (*)(RandomNumbers& random, int corners);

void add_target(Scene& scene, int vertex, const Vec2& target) {
  const HandleKind kind = target == scene.rest.col(vertex) ? HandleKind::pin : HandleKind::drag;
  scene.handles.push_back({static_cast<int>(scene.handles.size()) + 1, vertex, target, kind});
}

Scene scene_over(const Shape& shape) {
  Scene scene;
  scene.triangles = shape.triangles;
  scene.rest = shape.rest.unaryExpr(&suite_coordinate);
  return scene;
}

/// The boundary of a disk, which is on its left.
std::vector<int> boundary_loop(const Scene& scene) {
  const auto neighbours = boundary_neighbours(scene.triangles, static_cast<int>(scene.rest.cols()));
  const auto first = std::ranges::find_if(neighbours, &BoundaryNeighbours::are_there);
  return boundary_loop(neighbours, static_cast<int>(first - neighbours.begin()));
}

/// The boundary to the corners of a polygon, the first to that of an index.
Scene held_boundary(RandomNumbers& random, Scene scene, Polygon polygon, double offset = 0) {
  const std::vector<int> loop = boundary_loop(scene);
  const Points targets = polygon(random, static_cast<int>(loop.size()));
  const auto first = static_cast<std::size_t>(offset * static_cast<double>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i)
    add_target(scene, loop[i], targets.col(static_cast<Eigen::Index>((i + first) % loop.size())));
  return scene;
}

Scene round_disk(RandomNumbers& random, int least_rings, int most_rings) {
  const int rings = random.integer(least_rings, most_rings);
  return scene_over(disk({.rings = rings,
                          .boundary_vertices = 6 * rings,
                          .vertices = 1 + 3 * rings * (rings + 1),
                          .radius = 0.35}));
}

Scene square(RandomNumbers& random) {
  const int cells = random.integer(8, 16);
  return scene_over(grid({.columns = cells,
                          .rows = cells,
                          .width = 0.7,
                          .height = 0.7,
                          .diagonal = Diagonal::alternating}));
}

Scene star(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 5, 14), star_polygon);
}
Scene comb(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 5, 14), comb_polygon);
}
Scene spiral(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 8, 18), spiral_polygon);
}
Scene polygon(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 5, 14), random_polygon);
}
Scene turned(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 5, 14), random_polygon, 0.25);
}
Scene strip(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 6, 14), wound_strip_polygon);
}
Scene glued(RandomNumbers& random) {
  return held_boundary(random, round_disk(random, 5, 10), glued_triangles_polygon);
}

Scene straight(RandomNumbers& random) {
  constexpr std::array<Polygon, 3> kPolygons{random_polygon, comb_polygon, glued_triangles_polygon};
  return held_boundary(random, square(random), kPolygons[random.below(kPolygons.size())]);
}

Scene bent(RandomNumbers& random) {
  Shape shape = bar(random.between(4, 8), 1, random.integer(2, 4));
  const double turns = random.between(0.4, 0.9), length = shape.rest.row(0).maxCoeff();
  for (auto p : shape.rest.colwise()) {
    const double angle = 2 * std::numbers::pi * turns * p.x() / length;
    p = (0.2 + 0.2 * p.y()) * Vec2(std::sin(angle), std::cos(angle));
  }
  constexpr std::array<Polygon, 3> kPolygons{random_polygon, star_polygon, glued_triangles_polygon};
  return held_boundary(random, scene_over(shape), kPolygons[random.below(kPolygons.size())]);
}

/// Holds the boundary; returns the vertices inside, in random order.
std::vector<int> hold_boundary(RandomNumbers& random, Scene& scene) {
  std::vector<bool> is_inside(static_cast<std::size_t>(scene.rest.cols()), true);
  for (const int v : boundary_loop(scene)) {
    is_inside[static_cast<std::size_t>(v)] = false;
    add_target(scene, v, scene.rest.col(v));
  }
  std::vector<int> inside;
  for (int v = 0; v < static_cast<int>(is_inside.size()); ++v)
    if (is_inside[static_cast<std::size_t>(v)]) inside.push_back(v);
  for (std::size_t i = inside.size(); i > 1; --i) std::swap(inside[i - 1], inside[random.below(i)]);
  return inside;
}

Scene swap(RandomNumbers& random) {
  Scene scene = square(random);
  std::vector<int> inside = hold_boundary(random, scene);
  inside.resize(static_cast<std::size_t>(random.integer(4, 20)));
  for (std::size_t i = 0; i < inside.size(); ++i)
    add_target(scene, inside[i], scene.rest.col(inside[(i + 1) % inside.size()]));
  return scene;
}

Scene vortices(RandomNumbers& random) {
  Scene scene = square(random);
  std::vector<int> inside = hold_boundary(random, scene);
  PlaneMap map;
  for (int i = random.integer(2, 4); i > 0; --i) {
    const double x = random.between(0.2, 0.5), y = random.between(0.2, 0.5);
    const double radius = std::min({x, y, 0.7 - x, 0.7 - y});
    const double angle = random.sign() * random.between(0.7, 2.5);
    map.moves.emplace_back(Twist{{x, y}, radius, 0.3 * radius, angle});
  }
  inside.resize(std::min(inside.size(), static_cast<std::size_t>(random.integer(60, 200))));
  for (const int v : inside)
    add_target(scene, v, map(scene.rest.col(v)).unaryExpr(&suite_coordinate));
  return scene;
}

Scene stretched(RandomNumbers& random) {
  Scene scene = square(random);
  Mat2 affine;
  affine << std::pow(10, random.between(1, 3)), random.between(-5, 5), 0, 1;
  PlaneMap map;
  std::vector<int> handles;
  for (int i = random.integer(3, 8); i > 0; --i) {
    const int v = static_cast<int>(random.below(static_cast<std::size_t>(scene.rest.cols())));
    const double angle = random.between(0, 2 * std::numbers::pi);
    map.moves.emplace_back(
        Drag{scene.rest.col(v), 0.25, 0.12 * Vec2(std::cos(angle), std::sin(angle))});
    if (std::ranges::find(handles, v) == handles.end()) handles.push_back(v);
  }
  const Points rest = scene.rest;
  scene.rest = (affine * rest).unaryExpr(&suite_coordinate);
  for (const int v : handles)
    add_target(scene, v, (affine * map(rest.col(v))).unaryExpr(&suite_coordinate));
  return scene;
}

constexpr std::array kKindsOfScenes{
    HardKind{"star", star},       HardKind{"comb", comb},         HardKind{"spiral", spiral},
    HardKind{"polygon", polygon}, HardKind{"turned", turned},     HardKind{"strip", strip},
    HardKind{"glued", glued},     HardKind{"straight", straight}, HardKind{"bent", bent},
    HardKind{"swap", swap},       HardKind{"vortices", vortices}, HardKind{"stretched", stretched},
};
static_assert(kHardScenes % kKindsOfScenes.size() == 0);

}  // namespace

std::span<const HardKind> hard_kinds() { return kKindsOfScenes; }

BenchScene hard_scene(std::uint64_t seed, int index) {
  // Two rounds, so that neighbouring seeds and indices share nothing.
  RandomNumbers random(RandomNumbers(seed).next() ^ static_cast<std::uint64_t>(index));
  const auto number = static_cast<std::size_t>(index);
  const HardKind& kind = kKindsOfScenes[number % kKindsOfScenes.size()];
  BenchScene result;
  result.difficulty = kind.name;
  result.scene = kind.draw(random);
  result.scene.energy = &densities()[number % densities().size()];
  std::string digits = std::to_string(index);
  if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
  result.name = "hard" + std::to_string(seed) + "-" + digits + "-" + std::string(kind.name);
  result.scene.description = result.name;
  return result;
}

}  // namespace foldless
