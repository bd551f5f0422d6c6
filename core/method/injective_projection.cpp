// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/injective_projection.h"

#include <algorithm>
#include <utility>

#include "core/method/map_words.h"

namespace foldless {
namespace {

constexpr double kProjectionTolerance = 1e-9;  ///< of the programs
constexpr double kBoundSlack = 1e-6;           ///< relative, of the largest σ₁/σ₂ over K
constexpr double kStagnation = 1e-12;          ///< ‖u_{n+1} − u_n‖²
constexpr int kMostPrograms = 100;

}  // namespace

InjectiveProjection::InjectiveProjection(Problem problem)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      positions_(positions_of(problem.handles)),
      system_(problem, "injective-projection"),
      checker_(mesh_.triangles(), mesh_.vertex_count()) {
  begin();
}

std::unique_ptr<Method> InjectiveProjection::clone() const {
  return std::make_unique<InjectiveProjection>(*this);
}

void InjectiveProjection::set_targets(const Points& targets) {
  positions_.targets = targets;
  begin();
}

void InjectiveProjection::begin() {
  outcome_.reset();
  verdict_.clear();
  has_minimum_ = false;
  programs_ = 0;
  const Points at_targets = system_.with_handles(mesh_.deformed(), positions_.targets);
  if (!system_.are_held_triangles_bounded(at_targets, parameters_.distortion_bound))
    return end(Outcome::infeasible,
               "infeasible: a triangle of three handles is folded, or distorted beyond the bound");
  if (system_.triangle_count() > 0) return;
  mesh_.set_deformed(at_targets);
  end(Outcome::step, words_on(checker_.check(at_targets)));
}

std::optional<Iteration> InjectiveProjection::step(std::stop_token token) {
  if (outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  const Points before = mesh_.deformed();
  const bool was_done = advance(token);
  seconds_ += thread_seconds() - start;
  if (!was_done) return std::nullopt;
  Iteration iteration = system_.record(mesh_, before, positions_);
  iteration.inner = programs_;
  iteration.updates = updates_;
  iteration.step_length = mesh_.deformed() == before ? 0 : 1;
  iteration.seconds = seconds_;
  return iteration;
}

/// False when cancelled.
bool InjectiveProjection::advance(const std::stop_token& token) {
  if (has_minimum_) return project(token);
  const Points held = system_.with_handles(mesh_.deformed(), positions_.targets);
  auto minimum = system_.unconstrained_minimum(held, positions_.targets, token);
  if (!minimum) return false;
  mesh_.set_deformed(*std::move(minimum));
  ++updates_;
  has_minimum_ = true;
  judge(1);
  return true;
}

bool InjectiveProjection::project(const std::stop_token& token) {
  const Points& u = mesh_.deformed();
  const ConeSolution solution = system_.solver.solve(
      system_.program(u, positions_.targets, half_planes()), kProjectionTolerance, token);
  if (solution.status == ConeStatus::cancelled) return false;
  ++programs_;
  if (solution.status == ConeStatus::infeasible) {
    end(Outcome::infeasible, "infeasible for these half-planes (certificate)");
  } else if (solution.status == ConeStatus::not_converged) {
    end(Outcome::not_converged, "a quadratic program did not converge");
  } else {
    Points next = system_.moved(u, solution.x);
    const double step_squared = (next - u).squaredNorm();
    mesh_.set_deformed(std::move(next));
    ++updates_;
    judge(step_squared);
  }
  return true;
}

// ‖J‖² = 2(|f_z|² + |f_z̄|²).
std::vector<TriangleTerm> InjectiveProjection::half_planes() const {
  const double k = dilatation_bound(parameters_.distortion_bound);
  std::vector<TriangleTerm> terms;
  for (const ConformalParts& now : system_.parts(mesh_.deformed())) {
    const Complex z = direction_of(now.f_z, 1);
    const Complex zbar = direction_of(now.f_zbar, 1);
    TriangleTerm& term = terms.emplace_back(TriangleTerm{2, 2, now.f_z, now.f_zbar});
    term.R.row(0) << k * z.real(), k * z.imag(), -zbar.real(), -zbar.imag();
  }
  return terms;
}

void InjectiveProjection::judge(double step_squared) {
  const InjectivityReport report = checker_.check(mesh_.deformed());
  const double K = parameters_.distortion_bound * (1 + kBoundSlack);
  const std::string words = words_on(report);
  const int most = std::min(kMostPrograms, parameters_.inner_iterations);
  if (report.inverted + report.degenerate == 0 && system_.is_bounded(mesh_.deformed(), K))
    end(Outcome::step, words);
  else if (step_squared < kStagnation)
    end(Outcome::not_converged, "it no longer moves" + (words.empty() ? "" : ": " + words));
  else if (programs_ >= most)
    end(Outcome::iteration_limit, words);
}

void InjectiveProjection::end(Outcome outcome, std::string verdict) {
  outcome_ = outcome;
  verdict_ = std::move(verdict);
}

}  // namespace foldless
