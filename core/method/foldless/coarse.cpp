// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/injective.h"
#include "core/method/foldless.h"
#include "core/remesh/prolong.h"

namespace foldless {
namespace {

/// From so many vertices on it was measured to pay.
constexpr int kDenseFrom = 8000;
constexpr int kLeastVertices = 3500;
/// Vertices of the fine mesh to one of the coarse.
constexpr int kRatio = 8;
/// The coarse mesh has at most this part of the vertices.
constexpr double kLargestPart = 0.5;

}  // namespace

std::optional<Coarse> Coarse::of(const Problem& problem) {
  const MeshPair& mesh = problem.mesh;
  if (mesh.vertex_count() < kDenseFrom) return std::nullopt;
  std::vector<int> handles;
  for (const Handle& handle : problem.handles) handles.push_back(handle.vertex);
  CoarseMesh coarse =
      coarsened(mesh, handles, std::max(kLeastVertices, mesh.vertex_count() / kRatio));
  if (coarse.mesh.vertex_count() > kLargestPart * mesh.vertex_count() ||
      !is_injective(coarse.mesh.triangles(), coarse.mesh.deformed()))
    return std::nullopt;
  Problem small{coarse.mesh, problem.energy, problem.handles, problem.parameters};
  for (Handle& handle : small.handles)
    handle.vertex = static_cast<int>(std::ranges::lower_bound(coarse.vertices, handle.vertex) -
                                     coarse.vertices.begin());
  return Coarse(std::move(coarse), std::move(small));
}

Coarse::Coarse(CoarseMesh coarse, Problem problem)
    : coarse_(std::move(coarse)), run_(std::make_unique<Foldless>(std::move(problem))) {}

Coarse::Coarse(const Coarse& other) : coarse_(other.coarse_), run_(other.run_->clone()) {}

Coarse& Coarse::operator=(const Coarse& other) { return *this = Coarse(other); }

Progress Coarse::step(Workspace& workspace, std::stop_token token, Iteration& iteration) {
  const std::optional<Iteration> step = run_->step(token);
  if (!step && !run_->outcome()) return Progress::cancelled;
  if (step) {
    iteration = *step;
    workspace.system.counters = {step->factorizations, step->updates};
    workspace.system.times = run_->times();
  }
  if (!run_->outcome()) return Progress::running;
  if (run_->outcome() != Outcome::gradient) return Progress::locked;
  coarse_.mesh = run_->mesh();
  const EnergySettings& energy = workspace.system.objective().settings();
  std::optional<ProlongedMesh> fine = prolonged(coarse_, workspace.mesh, energy);
  if (!fine) return Progress::locked;
  workspace.flips += fine->flips;
  workspace.set_mesh(std::move(fine->mesh));
  return Progress::arrived;
}

}  // namespace foldless
