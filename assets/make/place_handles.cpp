// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/place_handles.h"

#include <Eigen/Geometry>
#include <numbers>
#include <utility>

#include "core/energy/densities.h"

namespace foldless::samples {

Scene scene_over(const SampleMesh& mesh, const char* energy, std::string description) {
  Scene scene;
  scene.mesh_path = "../meshes/" + mesh.name + ".obj";
  scene.triangles = mesh.shape.triangles;
  scene.rest = mesh.shape.rest;
  scene.energy = find_density(energy);
  scene.description = std::move(description);
  scene.parameters.method = "paper-flip";
  return scene;
}

void add_handle(Scene& scene, int vertex, const Vec2& target, HandleKind kind) {
  const int id = static_cast<int>(scene.handles.size()) + 1;
  scene.handles.push_back({id, vertex, target, kind});
}

void pin(Scene& scene, const std::vector<int>& vertices) {
  for (const int v : vertices) add_handle(scene, v, scene.rest.col(v), HandleKind::pin);
}

Vec2 turned(const Vec2& p, const Vec2& centre, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return centre + Eigen::Rotation2Dd(angle) * (p - centre);
}

void turn(Scene& scene, const std::vector<int>& vertices, const Vec2& centre, double degrees) {
  for (const int v : vertices) add_handle(scene, v, turned(scene.rest.col(v), centre, degrees));
}

int nearest_vertex(const Scene& scene, const Vec2& p) {
  Eigen::Index nearest = 0;
  (scene.rest.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

std::vector<int> grid_square(const GridOptions& grid, int first, int last, bool border_only) {
  std::vector<int> vertices;
  for (int j = first; j <= last; ++j)
    for (int i = first; i <= last; ++i) {
      const bool border = i == first || i == last || j == first || j == last;
      if (border || !border_only) vertices.push_back(j * (grid.columns + 1) + i);
    }
  return vertices;
}

std::vector<int> vertices_near(const Scene& scene, const Vec2& centre, double radius) {
  std::vector<int> vertices;
  for (int v = 0; v < scene.rest.cols(); ++v)
    if ((scene.rest.col(v) - centre).norm() < radius) vertices.push_back(v);
  return vertices;
}

void drag(Scene& scene, const Vec2& from, const Vec2& to) {
  add_handle(scene, nearest_vertex(scene, from), to);
}

void pin_at(Scene& scene, const std::vector<Vec2>& places) {
  for (const Vec2& p : places) pin(scene, {nearest_vertex(scene, p)});
}

void exchange(Scene& scene, int a, int b) {
  add_handle(scene, a, scene.rest.col(b));
  add_handle(scene, b, scene.rest.col(a));
}

}  // namespace foldless::samples
