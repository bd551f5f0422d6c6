// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/coarse.h"

#include <algorithm>
#include <utility>

#include "core/mesh/injective.h"
#include "core/method/foldless.h"
#include "core/remesh/prolong.h"

namespace foldless {
namespace {

/// The coarse mesh has at most this part of the vertices.
constexpr double kLargestPart = 0.5;

double longest_way(const Problem& problem) {
  double longest = 0;
  for (const Handle& handle : problem.handles)
    longest =
        std::max(longest, (handle.target - problem.mesh.deformed().col(handle.vertex)).norm());
  return longest;
}

/// Handles, and what does not move.
std::vector<int> kept_vertices(const Problem& problem) {
  std::vector<int> kept;
  for (const Handle& handle : problem.handles) kept.push_back(handle.vertex);
  const Unknowns unknowns = unknowns_of(problem.mesh, kept);
  for (int v = 0; v < problem.mesh.vertex_count(); ++v)
    if (unknowns.node_of_vertex[static_cast<std::size_t>(v)] < 0) kept.push_back(v);
  return kept;
}

}  // namespace

std::optional<Coarse> Coarse::of(const Problem& problem, const CoarseSettings& settings) {
  const int count = problem.mesh.vertex_count();
  if (count < settings.dense_from || longest_way(problem) < settings.short_way) return std::nullopt;
  CoarseMesh coarse = coarsened(problem.mesh, kept_vertices(problem),
                                std::max(settings.least_vertices, count / settings.ratio));
  if (coarse.mesh.vertex_count() > kLargestPart * count ||
      !is_injective(coarse.mesh.triangles(), coarse.mesh.deformed()))
    return std::nullopt;
  Problem small{std::move(coarse.mesh), problem.energy, problem.handles, problem.parameters};
  for (Handle& handle : small.handles)
    handle.vertex = static_cast<int>(std::ranges::lower_bound(coarse.vertices, handle.vertex) -
                                     coarse.vertices.begin());
  return Coarse(std::move(coarse.vertices), std::make_unique<Foldless>(std::move(small), settings));
}

Coarse::Coarse(std::vector<int> vertices, std::unique_ptr<Method> run)
    : vertices_(std::move(vertices)), run_(std::move(run)) {}

Coarse::Coarse(const Coarse& other) : Coarse(other.vertices_, other.run_->clone()) {}

Coarse& Coarse::operator=(const Coarse& other) { return *this = Coarse(other); }

Progress Coarse::step(Workspace& workspace, std::stop_token token, Iteration& iteration) {
  const std::optional<Iteration> step = run_->step(token);
  if (!step) return Progress::cancelled;
  iteration = *step;
  workspace.system.counters = {step->factorizations, step->updates};
  workspace.system.times = run_->times();
  workspace.flips = step->flips;
  workspace.splits = step->splits;
  if (!run_->outcome()) return Progress::running;
  if (run_->outcome() != Outcome::gradient) return Progress::locked;
  std::optional<ProlongedMesh> fine =
      prolonged({run_->mesh(), vertices_}, workspace.mesh, workspace.system.objective().settings());
  if (!fine) return Progress::locked;
  workspace.flips += fine->flips;
  workspace.set_mesh(std::move(fine->mesh));
  return Progress::arrived;
}

}  // namespace foldless
