// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/random_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/data_path.h"
#include "core/files/mesh_io.h"
#include "core/mesh/generate.h"
#include "core/mesh/mesh_pair.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

Shape random_grid(RandomNumbers& random) {
  constexpr std::array kDiagonals{Diagonal::rising, Diagonal::falling, Diagonal::alternating};
  const int columns = random.integer(7, 26);
  const int rows = random.integer(7, 26);
  const double cell = 1.0 / std::max(columns, rows);
  return grid({.columns = columns,
               .rows = rows,
               .width = columns * cell,
               .height = rows * cell,
               .diagonal = kDiagonals[random.below(kDiagonals.size())]});
}

Shape random_disk(RandomNumbers& random) {
  const int rings = random.integer(5, 15);
  return disk({.rings = rings,
               .boundary_vertices = 6 * rings,
               .vertices = 1 + 3 * rings * (rings + 1),
               .radius = 0.5});
}

Shape random_annulus(RandomNumbers& random) {
  return annulus({.inner_radius = random.between(0.12, 0.3),
                  .outer_radius = 0.5,
                  .sectors = random.integer(24, 60),
                  .layers = random.integer(4, 9)});
}

Shape dense_grid(RandomNumbers& random) {
  const int n = random.integer(30, 50);
  return grid({.columns = n, .rows = n, .diagonal = Diagonal::alternating});
}

Shape dense_disk(RandomNumbers& random) {
  const int rings = random.integer(19, 28);
  return disk({.rings = rings,
               .boundary_vertices = 6 * rings,
               .vertices = 1 + 3 * rings * (rings + 1),
               .radius = 0.5});
}

/// A mesh of assets/meshes, about as large as the others.
Shape sample(const char* name, double scale) {
  LoadedMesh mesh = read_mesh(data_path("assets/meshes/" + std::string(name) + ".obj"));
  return {std::move(mesh.triangles), scale * mesh.points};
}

Shape gingerbread_mesh(RandomNumbers&) { return sample("gingerbread", 0.5); }
Shape alligator_mesh(RandomNumbers&) { return sample("alligator", 0.25); }
Shape cowboy_mesh(RandomNumbers&) { return sample("cowboy", 0.25); }
Shape bar_mesh(RandomNumbers&) { return sample("bar_with_hole", 0.25); }

/// A kind of mesh, and how often it comes.
struct Kind {
  const char* name;
  std::size_t weight;
  Shape (*make)(RandomNumbers& random);
};

constexpr std::array kKinds{
    Kind{"grid", 9, random_grid},       Kind{"disk", 9, random_disk},
    Kind{"annulus", 4, random_annulus}, Kind{"gingerbread", 4, gingerbread_mesh},
    Kind{"cowboy", 3, cowboy_mesh},     Kind{"alligator", 2, alligator_mesh},
    Kind{"bar-with-hole", 2, bar_mesh}, Kind{"dense-grid", 1, dense_grid},
    Kind{"dense-disk", 2, dense_disk},
};

const Kind& random_kind(RandomNumbers& random) {
  std::size_t total = 0;
  for (const Kind& kind : kKinds) total += kind.weight;
  std::size_t left = random.below(total);
  for (const Kind& kind : kKinds) {
    if (left < kind.weight) return kind;
    left -= kind.weight;
  }
  return kKinds.back();
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 edge = b - a;
  const double t = std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
  return (p - a - t * edge).norm();
}

void measure_boundary(RandomMesh& mesh) {
  const Points& rest = mesh.shape.rest;
  const MeshPair pair(mesh.shape.triangles, rest);
  std::vector<Edge> boundary;
  for (int e = 0; e < pair.edge_count(); ++e)
    if (pair.is_boundary_edge(e)) boundary.push_back(pair.edge(e));
  for (int v = 0; v < pair.vertex_count(); ++v) {
    mesh.is_boundary.push_back(pair.is_boundary_vertex(v));
    double clearance = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : boundary)
      clearance = std::min(clearance, distance_to_segment(rest.col(v), rest.col(a), rest.col(b)));
    mesh.clearance.push_back(clearance);
  }
}

}  // namespace

double suite_coordinate(double value) { return std::round(value * 0x1p20) * 0x1p-20; }

RandomMesh random_mesh(RandomNumbers& random) {
  const Kind& kind = random_kind(random);
  RandomMesh mesh;
  mesh.name = kind.name;
  mesh.shape = kind.make(random);
  mesh.shape.rest = mesh.shape.rest.unaryExpr(&suite_coordinate);
  mesh.diagonal = bounding_box_diagonal(mesh.shape.rest);
  measure_boundary(mesh);
  return mesh;
}

}  // namespace foldless
