// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/walk_over.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/mesh/injective.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/solve/map_interpolation.h"

namespace foldless {
namespace walking {

/// A vertex that moves less is not seen to jump. [D]
constexpr double kUnseen = 2e-3;

bool is_seen(const Workspace& work, const MeshPair& to) {
  const Eigen::Index common = std::min(work.mesh.vertex_count(), to.vertex_count());
  const Points way = to.deformed().leftCols(common) - work.mesh.deformed().leftCols(common);
  return way.colwise().norm().maxCoeff() > kUnseen * work.settings->diagonal;
}

/// The triangles of one mesh with the positions of the other, where that is valid.
std::optional<MeshPair> with_positions(const MeshPair& triangles, const MeshPair& positions) {
  if (triangles.vertex_count() != positions.vertex_count() ||
      triangles.rest() != positions.rest() ||
      !is_injective(triangles.triangles(), positions.deformed()))
    return std::nullopt;
  return MeshPair(triangles.triangles(), positions.rest(), positions.deformed());
}

/// The way, with the triangulation of `work` that bears it.
std::vector<Points> way_on_either(Workspace& work, const MeshPair& to) {
  if (auto start = with_positions(to, work.mesh)) {
    Workspace other = work;
    other.set_mesh(*std::move(start));
    std::vector<Points> way = way_over(other, to.deformed());
    if (!way.empty()) {
      work = std::move(other);
      return way;
    }
  }
  if (!with_positions(work.mesh, to)) return {};
  return way_over(work, to.deformed());
}

VertexUpdate move_to(const Points& positions, MeshPair& mesh) {
  const double moved = (positions - mesh.deformed()).cwiseAbs().maxCoeff();
  mesh.set_deformed(positions);
  return {.step_length = 1, .step_infinity_norm = moved};
}

/// Of springs that pull every vertex, against a density of energy. [1/D²]
constexpr double kSprings = 3000;
/// Steps of the descent for a step of the walk.
constexpr int kStepsAtAStop = 2;

/// The handles, and a spring at every other vertex, as strong as its share of the rest area.
Constraints with_springs(const Workspace& work) {
  const MeshPair& mesh = work.mesh;
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (const auto& t : mesh.triangles().colwise())
    for (const int v : t) areas[v] += signed_area(mesh.rest(), t) / 3;
  Constraints springs = held(work.constraints);
  std::vector<bool> is_handle(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (const int v : springs.vertices) is_handle[static_cast<std::size_t>(v)] = true;
  std::vector<double> weights(springs.weights.begin(), springs.weights.end());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (is_handle[static_cast<std::size_t>(v)] || areas[v] == 0) continue;
    springs.vertices.push_back(v);
    springs.soft.push_back(true);
    weights.push_back(areas[v]);
  }
  springs.weights = Eigen::Map<Eigen::VectorXd>(weights.data(), std::ssize(weights));
  springs.targets = handle_positions(springs, mesh.deformed());
  return springs;
}

/// Springs lead the mesh along where the way itself would leave the feasible set: every step goes
/// down, and is bounded.
Steps<> be_led_over(Workspace& work, const Points& to) {
  const MeshPair from = work.mesh;
  MapInterpolation between(from, work.constraints, to);
  if (!between.is_solvable()) co_return;
  Workspace led(work.mesh, with_springs(work), *work.settings, work.system.effort());
  Energy energy{work.settings->energy, led.constraints};
  energy.settings.alpha = kSprings / (work.settings->diagonal * work.settings->diagonal);
  FlippingDescent descent(FactorUse::lagged);
  const auto next = [&](const std::stop_token& token) { return descent.step(led, energy, token); };
  for (int k = 1; k <= kStepsOfAWalk; ++k) {
    const Points stop = between.at(static_cast<double>(k) / kStepsOfAWalk);
    energy.constraints.targets = handle_positions(led.constraints, stop);
    for (int step = 0; step < kStepsAtAStop; ++step) {
      const VertexUpdate update = co_await vertex_update(next);
      work.set_mesh(led.mesh);
      co_yield work.record(update, work.held_energy(), Phase::walk);
    }
  }
}

}  // namespace walking

std::vector<Points> way_over(const Workspace& work, const Points& to) {
  MapInterpolation between(work.mesh, work.constraints, to);
  if (!between.is_solvable()) return {};
  std::vector<Points> way;
  Points here = work.mesh.deformed();
  for (int k = 1; k <= kStepsOfAWalk; ++k) {
    Points next = between.at(static_cast<double>(k) / kStepsOfAWalk);
    const double bound =
        work.system.objective().largest_step(work.settings->energy, here, next - here);
    if (!(bound > 1)) return {};
    way.push_back(next);
    here = std::move(next);
  }
  return way;
}

Steps<> walk_over(Workspace& work, MeshPair to) {
  using namespace walking;
  if (is_seen(work, to) && work.mesh.vertex_count() == to.vertex_count()) {
    const std::vector<Points> way = way_on_either(work, to);
    if (way.empty()) co_await be_led_over(work, to.deformed());
    for (const Points& stop : way) {
      const auto next = [&](const std::stop_token&) { return move_to(stop, work.mesh); };
      const VertexUpdate update = co_await vertex_update(next);
      co_yield work.record(update, work.held_energy(), Phase::walk);
    }
  }
  work.set_mesh(std::move(to));
  co_yield [&work](Iteration& last) { work.measure_again(last, work.held_energy()); };
}

}  // namespace foldless
