// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_patches.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/linear/shared_vectors.h"
#include "core/mesh/patches.h"
#include "core/solve/line_search.h"
#include "core/solve/patch_energy.h"

namespace foldless {
namespace {

constexpr int kRings = 8;
/// Of the vertices; where more are near, a step of the whole costs little more.
constexpr double kMostNear = 0.05;
constexpr int kMostCarries = 3;

std::size_t as_size(int i) { return static_cast<std::size_t>(i); }

/// Vertices near some triangles.
struct NearVertices {
  std::vector<int> vertices;
  std::vector<bool> is_near;

  void add(int v) {
    if (is_near[as_size(v)]) return;
    is_near[as_size(v)] = true;
    vertices.push_back(v);
  }
};

/// Nothing where they are too many, or none.
std::optional<NearVertices> near_vertices(const MeshPair& mesh, const std::vector<int>& triangles) {
  NearVertices near{{}, std::vector<bool>(as_size(mesh.vertex_count()))};
  const auto most = static_cast<std::size_t>(kMostNear * mesh.vertex_count());
  if (triangles.size() > most) return std::nullopt;
  for (const int t : triangles)
    for (const int v : mesh.triangles().col(t)) near.add(v);
  std::size_t done = 0;
  for (int ring = 0; ring < kRings && near.vertices.size() <= most; ++ring)
    for (const std::size_t end = near.vertices.size(); done < end; ++done)
      for (const int t : mesh.triangles_of_vertex(near.vertices[done]))
        for (const int v : mesh.triangles().col(t)) near.add(v);
  if (near.vertices.empty() || near.vertices.size() > most) return std::nullopt;
  return near;
}

/// By vertex, whether it is near and neither a held handle nor at the boundary.
std::vector<bool> free_vertices(const MeshPair& mesh, const Constraints& constraints,
                                const NearVertices& near) {
  std::vector<bool> is_free = near.is_near;
  for (const int v : near.vertices)
    if (mesh.is_boundary_vertex(v)) is_free[as_size(v)] = false;
  for (int i = 0; i < constraints.count(); ++i)
    if (constraints.is_eliminated(i)) is_free[as_size(constraints.vertices[as_size(i)])] = false;
  return is_free;
}

/// Those at free vertices, in the order of the mesh.
Triangles triangles_at(const MeshPair& mesh, const NearVertices& near,
                       const std::vector<bool>& is_free) {
  std::vector<int> triangles;
  for (const int v : near.vertices)
    if (is_free[as_size(v)])
      for (const int t : mesh.triangles_of_vertex(v)) triangles.push_back(t);
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return mesh.triangles()(Eigen::all, triangles);
}

/// Whether the held vertices of a patch came to their targets.
bool arrives(MeshPair& patch, const Energy& energy, Effort& effort, const std::stop_token& token) {
  NewtonSystem system(patch, energy.constraints, effort);
  for (int carry = 0; carry < kMostCarries; ++carry) {
    const VertexUpdate update = carry_handles(system, patch, energy, token);
    if (update.step_length == 1) return true;
    if (update.cancelled || update.step_length == 0) return false;
  }
  return false;
}

}  // namespace

std::optional<Points> carry_patches(NewtonSystem& system, const MeshPair& mesh,
                                    const StoppedCarry& carry, const std::stop_token& token) {
  const auto& [energy, before, step, end] = carry;
  const Objective& objective = system.objective();
  // Boundary vertices go the whole step, and their gaps are bounded by it.
  if (kFirstTrial * objective.largest_step_of_gaps(energy.settings, before, step) < 1)
    return std::nullopt;
  const std::optional<NearVertices> near = near_vertices(
      mesh, objective.triangles_in_way(energy.settings, before, step, 1 / kFirstTrial));
  if (!near) return std::nullopt;
  const std::vector<bool> is_free = free_vertices(mesh, energy.constraints, *near);
  Points u = end;
  for (const Patch& patch : patches(triangles_at(mesh, *near, is_free), is_free)) {
    MeshPair part(patch.triangles, mesh.rest()(Eigen::all, patch.vertices),
                  mesh.deformed()(Eigen::all, patch.vertices));
    part.set_stiffness(mesh.stiffness());
    const Energy of_patch = energy_of(patch, end, is_free, energy);
    if (!arrives(part, of_patch, system.effort(), token)) return std::nullopt;
    u(Eigen::all, patch.vertices) = part.deformed();
  }
  if (!objective.is_feasible(energy.settings, mesh.deformed(), u)) return std::nullopt;
  return u;
}

VertexUpdate carry_handles_and_patches(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                                       const std::stop_token& token) {
  auto [update, stopped] = carry_as_far_as_possible(system, mesh, energy, token);
  if (!stopped) return update;
  if (std::optional<Points> u = carry_patches(system, mesh, *stopped, token)) {
    mesh.set_deformed(std::move(*u));
    update.step_length = 1;
    update.step_infinity_norm = largest_difference(mesh.deformed(), stopped->before);
  }
  return update;
}

}  // namespace foldless
