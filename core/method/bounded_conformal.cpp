// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/bounded_conformal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/files/text_lines.h"
#include "core/method/map_words.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

constexpr double kTolerance = 1e-9;        ///< of the programs at the targets
constexpr double kMovingTolerance = 1e-6;  ///< of those on the way
constexpr double kFirstStep = 0.1;         ///< of λ, and the largest
constexpr double kSmallestStep = 1e-3;
constexpr double kStepGrowth = 1.5;
constexpr double kEnergyGain = 1e-3;    ///< least relative decrease that asks for another program
constexpr double kEnergyFloor = 1e-12;  ///< of the same, absolute [D²]
constexpr double kFrameChange = 1e-4;   ///< least turn of a frame that does [rad]
constexpr int kMostImprovements = 30;
/// A start map must leave this much of K, so that its own frames have a map strictly inside.
constexpr double kStartMargin = 0.999;

std::string lambda_words(double lambda) {
  std::string words;
  append_number(words, std::round(1e3 * lambda) / 1e3);
  return words;
}

}  // namespace

BoundedConformal::BoundedConformal(const Problem& problem)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      constraints_(constraints_of(problem.handles)),
      system_(problem, "bounded-conformal"),
      checker_(mesh_.triangles(), mesh_.vertex_count()) {
  begin(solve());
}

void BoundedConformal::set_targets(const Points& targets) {
  constraints_.targets = targets;
  begin(solve());
}

Steps<Outcome> BoundedConformal::solve() {
  verdict_.clear();
  frames_.clear();
  const Points at_targets = system_.with_handles(mesh_.deformed(), constraints_.targets);
  if (!system_.are_held_triangles_bounded(at_targets, parameters_.distortion_bound))
    co_return end(
        Outcome::infeasible,
        "infeasible: a triangle of three handles is folded, or distorted beyond the bound");
  if (system_.triangle_count() == 0) {
    mesh_.set_deformed(at_targets);
    co_return end(Outcome::step, words_on(checker_.check(at_targets)));
  }
  std::optional<Outcome> ended;
  if (parameters_.start == StartFrames::continuation)
    ended = co_await continue_to_targets();
  else
    ended = co_await solve_with_given_frames();
  if (ended) co_return *ended;
  co_return co_await improve();
}

Steps<std::optional<Outcome>> BoundedConformal::solve_with_given_frames() {
  const Points before = mesh_.deformed();
  const auto first = [this](const std::stop_token& token) {
    if (frames_.empty() && !find_first_frames(token)) return Trial();
    return solve_program(constraints_.targets, kTolerance, token);
  };
  Trial trial = co_await vertex_update(first);
  const bool is_solved = trial.status == ConeStatus::solved;
  if (is_solved) {
    accept(std::move(trial.u));
    ++updates_;
  }
  co_yield record(before);
  if (is_solved) co_return std::nullopt;
  co_return end_without_map(trial, "");
}

// Ends where the farther of the two paths came to.
Steps<std::optional<Outcome>> BoundedConformal::continue_to_targets() {
  const Points start = start_of_paths();
  const Points handles = handle_positions(constraints_, start);
  const HandlePaths straight(PathKind::straight, handles, constraints_.targets);
  PathEnd farthest = co_await follow(start, straight);
  const HandlePaths similar(PathKind::similar, handles, constraints_.targets);
  if (farthest.lambda < 1 && similar.kind() == PathKind::similar) {
    PathEnd second = co_await follow(start, similar);
    if (second.lambda >= farthest.lambda)
      farthest = std::move(second);
    else
      farthest.last = std::move(second.last);
  }
  if (farthest.lambda >= 1) co_return std::nullopt;
  accept(std::move(farthest.u));
  co_return end_without_map(farthest.last, " beyond lambda " + lambda_words(farthest.lambda));
}

Points BoundedConformal::start_of_paths() const {
  const double K = parameters_.distortion_bound;
  const Points& u = mesh_.deformed();
  const bool can_start = system_.is_bounded(u, kStartMargin * K) &&
                         system_.are_held_triangles_bounded(u, K) &&
                         checker_.is_injective_inside(u);
  return can_start ? u : mesh_.rest();
}

Steps<BoundedConformal::PathEnd> BoundedConformal::follow(const Points& start,
                                                          const HandlePaths& path) {
  frames_.assign(static_cast<std::size_t>(system_.triangle_count()), 1);
  accept(start);
  PathEnd end{path.at(0) == constraints_.targets ? 1.0 : 0.0, start, {}};
  double step = kFirstStep;
  while (end.lambda < 1) {
    const Points before = mesh_.deformed();
    const double lambda = std::min(1.0, end.lambda + step);
    const auto move = [&](const std::stop_token& token) {
      return solve_program(path.at(lambda), kMovingTolerance, token);
    };
    Trial trial = co_await vertex_update(move);
    if (trial.status == ConeStatus::solved && !checker_.is_injective_inside(trial.u)) {
      trial.status = ConeStatus::not_converged;
      trial.why = "the maps fold or wind twice";
    }
    if (trial.status == ConeStatus::solved) {
      accept(std::move(trial.u));
      ++updates_;
      end.lambda = lambda;
      step = std::min(kFirstStep, kStepGrowth * step);
    } else {
      step = 0.5 * (lambda - end.lambda);
    }
    co_yield record(before);
    end.last = std::move(trial);
    if (step < kSmallestStep) break;
  }
  end.u = mesh_.deformed();
  co_return end;
}

Steps<Outcome> BoundedConformal::improve() {
  const auto words = [this] { return words_on(checker_.check(mesh_.deformed())); };
  const double D = bounding_box_diagonal(mesh_.rest());
  const double floor = kEnergyFloor * D * D;
  double energy = system_.energy(mesh_.deformed());
  const int most = std::min(kMostImprovements, parameters_.inner_iterations);
  for (int improvements = 1;; ++improvements) {
    const Points before = mesh_.deformed();
    const auto program = [this](const std::stop_token& token) {
      return solve_program(constraints_.targets, kTolerance, token);
    };
    Trial trial = co_await vertex_update(program);
    if (trial.status != ConeStatus::solved) {
      co_yield record(before);
      co_return end(Outcome::not_converged, trial.why + "; the map before stands");
    }
    const double next = system_.energy(trial.u);
    if (next > energy) {
      co_yield record(before);
      co_return end(Outcome::step, words());
    }
    const bool gains = energy - next > kEnergyGain * energy + floor;
    const double turn = accept(std::move(trial.u));
    ++updates_;
    energy = next;
    co_yield record(before);
    if (!gains || turn < kFrameChange) co_return end(Outcome::step, words());
    if (improvements >= most) co_return end(Outcome::iteration_limit, words());
  }
}

bool BoundedConformal::find_first_frames(const std::stop_token& token) {
  frames_.assign(static_cast<std::size_t>(system_.triangle_count()), 1);
  if (parameters_.start == StartFrames::rest) return true;
  const Points held = system_.with_handles(mesh_.deformed(), constraints_.targets);
  const auto minimum = system_.unconstrained_minimum(held, constraints_.targets, token);
  if (!minimum) {
    frames_.clear();
    return false;
  }
  const std::vector<ConformalParts> parts = system_.parts(*minimum);
  for (std::size_t t = 0; t < parts.size(); ++t) frames_[t] = direction_of(parts[t].f_z, 1);
  return true;
}

BoundedConformal::Trial BoundedConformal::solve_program(const Points& handle_positions,
                                                        double tolerance,
                                                        const std::stop_token& token) {
  const double K = parameters_.distortion_bound;
  const double k = dilatation_bound(K);
  const Points u = system_.with_handles(mesh_.deformed(), handle_positions);
  if (!system_.are_held_triangles_bounded(u, K))
    return {ConeStatus::infeasible, {}, "infeasible: a triangle of three handles folds"};
  const auto term_of = [&](std::size_t t) {
    TriangleTerm term = system_.energy_term(frames_[t]);
    // (k Re(e^{−iθ} f_z), Re f_z̄, Im f_z̄) is in the cone.
    term.R(0, 0) = k * frames_[t].real();
    term.R(0, 1) = k * frames_[t].imag();
    term.R(1, 2) = term.R(2, 3) = 1;
    return term;
  };
  const ConeSolution solution = system_.solve({u, handle_positions, term_of}, tolerance, token);
  switch (solution.status) {
    case ConeStatus::solved: return {solution.status, system_.moved(u, solution.x), ""};
    case ConeStatus::infeasible:
      return {solution.status, {}, "infeasible for these frames (certificate)"};
    case ConeStatus::not_converged: return {solution.status, {}, "a cone program did not converge"};
    case ConeStatus::cancelled: break;
  }
  return {};
}

double BoundedConformal::accept(Points u) {
  mesh_.set_deformed(std::move(u));
  const std::vector<ConformalParts> parts = system_.parts(mesh_.deformed());
  double largest_turn = 0;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const Complex frame = direction_of(parts[t].f_z, frames_[t]);
    largest_turn = std::max(largest_turn, std::abs(frame - frames_[t]));
    frames_[t] = frame;
  }
  return largest_turn;
}

Iteration BoundedConformal::record(const Points& before) {
  Iteration iteration = record_of(system_, mesh_, before, constraints_);
  iteration.inner = ++programs_;
  iteration.updates = updates_;
  iteration.step_length = mesh_.deformed() == before ? 0 : 1;
  return iteration;
}

Outcome BoundedConformal::end(Outcome outcome, std::string verdict) {
  verdict_ = std::move(verdict);
  return outcome;
}

Outcome BoundedConformal::end_without_map(const Trial& trial, const std::string& where) {
  return end(trial.status == ConeStatus::infeasible ? Outcome::infeasible : Outcome::not_converged,
             trial.why + where);
}

}  // namespace foldless
