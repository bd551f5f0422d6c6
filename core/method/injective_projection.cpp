// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/injective_projection.h"

#include <algorithm>
#include <utility>

#include "core/method/map_words.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

constexpr double kProjectionTolerance = 1e-9;  ///< of the programs
constexpr double kBoundSlack = 1e-6;           ///< relative, of the largest σ₁/σ₂ over K
constexpr double kStagnation = 1e-12;          ///< ‖u_{n+1} − u_n‖² [D²]
constexpr int kMostPrograms = 100;

}  // namespace

InjectiveProjection::InjectiveProjection(const Problem& problem)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      constraints_(constraints_of(problem.handles)),
      system_(problem, "injective-projection"),
      checker_(mesh_.triangles(), mesh_.vertex_count()) {
  begin(solve());
}

void InjectiveProjection::set_targets(const Points& targets) {
  constraints_.targets = targets;
  begin(solve());
}

Steps<Outcome> InjectiveProjection::solve() {
  verdict_.clear();
  const Points at_targets = system_.with_handles(mesh_.deformed(), constraints_.targets);
  if (!system_.are_held_triangles_bounded(at_targets, parameters_.distortion_bound))
    co_return end(
        Outcome::infeasible,
        "infeasible: a triangle of three handles is folded, or distorted beyond the bound");
  if (system_.triangle_count() == 0) {
    mesh_.set_deformed(at_targets);
    co_return end(Outcome::step, words_on(checker_.check(at_targets)));
  }
  const auto minimize = [this](const std::stop_token& token) {
    return unconstrained_minimum(token);
  };
  const auto program = [this](const std::stop_token& token) { return project(token); };
  for (int programs = 0;; ++programs) {
    const Points before = mesh_.deformed();
    Trial trial;
    if (programs == 0)
      trial = co_await vertex_update(minimize);
    else
      trial = co_await vertex_update(program);
    std::optional<Outcome> ended;
    if (trial.status == ConeStatus::infeasible) {
      ended = end(Outcome::infeasible, "infeasible for these half-planes (certificate)");
    } else if (trial.status == ConeStatus::not_converged) {
      ended = end(Outcome::not_converged, "a quadratic program did not converge");
    } else {
      mesh_.set_deformed(std::move(trial.u));
      ++updates_;
      const double step_squared = (mesh_.deformed() - before).squaredNorm();
      ended = judge(step_squared, programs);
    }
    co_yield record(before, programs);
    if (ended) co_return *ended;
  }
}

InjectiveProjection::Trial InjectiveProjection::unconstrained_minimum(
    const std::stop_token& token) {
  const Points held = system_.with_handles(mesh_.deformed(), constraints_.targets);
  auto minimum = system_.unconstrained_minimum(held, constraints_.targets, token);
  if (!minimum) return {};
  return {ConeStatus::solved, *std::move(minimum)};
}

InjectiveProjection::Trial InjectiveProjection::project(const std::stop_token& token) {
  const Points& u = mesh_.deformed();
  const std::vector<ConformalParts> parts = system_.parts(u);
  const auto half_plane_of = [&](std::size_t t) { return half_plane(parts[t]); };
  const ConeSolution solution =
      system_.solve({u, constraints_.targets, half_plane_of}, kProjectionTolerance, token);
  if (solution.status != ConeStatus::solved) return {solution.status, {}};
  return {solution.status, system_.moved(u, solution.x)};
}

// ‖J‖² = 2(|f_z|² + |f_z̄|²).
TriangleTerm InjectiveProjection::half_plane(const ConformalParts& now) const {
  const double k = dilatation_bound(parameters_.distortion_bound);
  const Complex z = direction_of(now.f_z, 1);
  const Complex zbar = direction_of(now.f_zbar, 1);
  TriangleTerm term{2, 2, now.f_z, now.f_zbar};
  term.R.row(0) << k * z.real(), k * z.imag(), -zbar.real(), -zbar.imag();
  return term;
}

std::optional<Outcome> InjectiveProjection::judge(double step_squared, int programs) {
  const InjectivityReport report = checker_.check(mesh_.deformed());
  const double K = parameters_.distortion_bound * (1 + kBoundSlack);
  const double D = bounding_box_diagonal(mesh_.rest());
  const std::string words = words_on(report);
  const int most = std::min(kMostPrograms, parameters_.inner_iterations);
  if (report.inverted + report.degenerate == 0 && system_.is_bounded(mesh_.deformed(), K))
    return end(Outcome::step, words);
  if (programs > 0 && step_squared < kStagnation * D * D)
    return end(Outcome::not_converged, "it no longer moves" + (words.empty() ? "" : ": " + words));
  if (programs >= most) return end(Outcome::iteration_limit, words);
  return std::nullopt;
}

Iteration InjectiveProjection::record(const Points& before, int programs) const {
  Iteration iteration = record_of(system_, mesh_, before, constraints_);
  iteration.inner = programs;
  iteration.updates = updates_;
  iteration.step_length = mesh_.deformed() == before ? 0 : 1;
  return iteration;
}

Outcome InjectiveProjection::end(Outcome outcome, std::string verdict) {
  verdict_ = std::move(verdict);
  return outcome;
}

}  // namespace foldless
