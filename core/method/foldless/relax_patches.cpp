// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/relax_patches.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/mesh/boundary.h"
#include "core/mesh/patches.h"
#include "core/solve/descent.h"
#include "core/solve/patch_energy.h"

namespace foldless {
namespace relaxing_patches {

constexpr int kRings = 8;
constexpr int kMostSteps = 10;
/// A patch is relaxed where the quadratic model promises less than this part of its E.
constexpr double kSmallDecrement = 1e-4;
/// Of the vertices; where more are in patches a step of the whole costs little more.
constexpr double kMostFree = 0.5;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// By vertex, whether it is near a triangle and may move.
std::vector<bool> free_vertices(const Workspace& work, const std::vector<int>& triangles) {
  const Triangles& all = work.mesh.triangles();
  std::vector<bool> is_free(at(work.mesh.vertex_count()));
  for (const int t : triangles)
    for (const int v : all.col(t)) is_free[at(v)] = true;
  grow(is_free, all, kRings);
  const auto boundary = boundary_neighbours(all, work.mesh.vertex_count());
  for (std::size_t v = 0; v < boundary.size(); ++v)
    if (boundary[v].are_there()) is_free[v] = false;
  for (int i = 0; i < work.constraints.count(); ++i)
    if (!work.constraints.soft[at(i)]) is_free[at(work.constraints.vertices[at(i)])] = false;
  return is_free;
}

/// Newton's method on the patch alone.
void relax(MeshPair& patch, const Energy& energy, Effort& effort, const std::stop_token& token) {
  NewtonSystem system(patch, energy.constraints, effort);
  Descent descent;
  for (int step = 0; step < kMostSteps; ++step) {
    const VertexUpdate update = descent.step(system, patch, energy, token);
    const bool is_relaxed = update.decrement <= kSmallDecrement * system.energy().total();
    if (update.cancelled || update.step_length == 0 || is_relaxed) return;
  }
}

}  // namespace relaxing_patches

void relax_patches(Workspace& work, const Energy& energy, const std::vector<int>& triangles,
                   const std::stop_token& token) {
  using namespace relaxing_patches;
  if (triangles.empty()) return;
  const MeshPair& mesh = work.mesh;
  const std::vector<bool> is_free = free_vertices(work, triangles);
  const auto free_count = static_cast<double>(std::ranges::count(is_free, true));
  if (free_count > kMostFree * mesh.vertex_count()) return;
  Points u = mesh.deformed();
  for (const Patch& patch : patches(mesh.triangles(), is_free)) {
    if (token.stop_requested()) break;
    MeshPair part(patch.triangles, mesh.rest()(Eigen::all, patch.vertices),
                  u(Eigen::all, patch.vertices));
    part.set_stiffness(mesh.stiffness());
    relax(part, energy_of(patch, u, is_free, energy), work.system.effort(), token);
    u(Eigen::all, patch.vertices) = part.deformed();
  }
  work.mesh.set_deformed(std::move(u));
  work.system.factor().outdate();
}

}  // namespace foldless
