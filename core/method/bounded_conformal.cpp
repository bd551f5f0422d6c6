// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/bounded_conformal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/text_lines.h"
#include "core/method/map_words.h"

namespace foldless {
namespace {

constexpr double kTolerance = 1e-9;        ///< of the programs at the targets
constexpr double kMovingTolerance = 1e-6;  ///< of those on the way
constexpr double kFirstStep = 0.1;         ///< of λ, and the largest
constexpr double kSmallestStep = 1e-3;
constexpr double kStepGrowth = 1.5;
constexpr double kEnergyGain = 1e-3;    ///< least relative decrease that asks for another program
constexpr double kEnergyFloor = 1e-12;  ///< of the same, absolute
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

BoundedConformal::BoundedConformal(Problem problem)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      positions_(positions_of(problem.handles)),
      system_(problem, "bounded-conformal"),
      checker_(mesh_.triangles(), mesh_.vertex_count()),
      path_(HandlePath::straight({}, {})) {
  begin();
}

std::unique_ptr<Method> BoundedConformal::clone() const {
  return std::make_unique<BoundedConformal>(*this);
}

void BoundedConformal::set_targets(const Points& targets) {
  positions_.targets = targets;
  begin();
}

Points BoundedConformal::handle_start() const {
  return held_where_they_are(positions_, start_).targets;
}

void BoundedConformal::begin() {
  outcome_.reset();
  verdict_.clear();
  improvements_ = 0;
  frames_.clear();
  farthest_lambda_ = 0;
  const double K = parameters_.distortion_bound;
  const Points at_targets = system_.with_handles(mesh_.deformed(), positions_.targets);
  if (!system_.are_held_triangles_bounded(at_targets, K))
    return end(Outcome::infeasible,
               "infeasible: a triangle of three handles is folded, or distorted beyond the bound");
  if (system_.triangle_count() == 0) {
    mesh_.set_deformed(at_targets);
    return end(Outcome::step, words_on(checker_.check(at_targets)));
  }
  stage_ = Stage::first;
  if (parameters_.start != StartFrames::continuation) return;
  start_ = mesh_.deformed();
  const bool can_start = system_.is_bounded(start_, kStartMargin * K) &&
                         system_.are_held_triangles_bounded(start_, K) &&
                         checker_.is_injective(start_);
  if (!can_start) start_ = mesh_.rest();
  is_second_path_ = false;
  begin_path(HandlePath::straight(handle_start(), positions_.targets));
  if (handle_start() != positions_.targets) return;
  stage_ = Stage::improving;
  energy_ = std::numeric_limits<double>::infinity();
}

void BoundedConformal::begin_path(HandlePath path) {
  path_ = std::move(path);
  lambda_ = 0;
  lambda_step_ = kFirstStep;
  stage_ = Stage::moving;
  frames_.assign(static_cast<std::size_t>(system_.triangle_count()), 1);
  take(start_);
}

std::optional<Iteration> BoundedConformal::step(std::stop_token token) {
  if (outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  const Points before = mesh_.deformed();
  const bool is_moving = stage_ == Stage::moving;
  const double lambda = is_moving ? std::min(1.0, lambda_ + lambda_step_) : 1;
  Attempt attempted;
  if (!frames_.empty() || find_first_frames(token))
    attempted = attempt(is_moving ? path_.at(lambda) : positions_.targets,
                        is_moving ? kMovingTolerance : kTolerance, token);
  const bool was_cancelled = attempted.status == ConeStatus::cancelled;
  if (!was_cancelled) {
    switch (stage_) {
      case Stage::first: take_first(std::move(attempted)); break;
      case Stage::moving: take_move(lambda, std::move(attempted)); break;
      case Stage::improving: take_improvement(std::move(attempted)); break;
    }
  }
  seconds_ += thread_seconds() - start;
  if (was_cancelled) return std::nullopt;
  Iteration iteration = system_.record(mesh_, before, positions_);
  iteration.inner = ++programs_;
  iteration.updates = updates_;
  iteration.step_length = mesh_.deformed() == before ? 0 : 1;
  iteration.seconds = seconds_;
  return iteration;
}

bool BoundedConformal::find_first_frames(const std::stop_token& token) {
  frames_.assign(static_cast<std::size_t>(system_.triangle_count()), 1);
  if (parameters_.start == StartFrames::rest) return true;
  const Points held = system_.with_handles(mesh_.deformed(), positions_.targets);
  const auto minimum = system_.unconstrained_minimum(held, positions_.targets, token);
  if (!minimum) {
    frames_.clear();
    return false;
  }
  const std::vector<ConformalParts> parts = system_.parts(*minimum);
  for (std::size_t t = 0; t < parts.size(); ++t) frames_[t] = direction_of(parts[t].f_z, 1);
  return true;
}

BoundedConformal::Attempt BoundedConformal::attempt(const Points& handle_positions,
                                                    double tolerance,
                                                    const std::stop_token& token) {
  const double K = parameters_.distortion_bound;
  const double k = dilatation_bound(K);
  const Points u = system_.with_handles(mesh_.deformed(), handle_positions);
  if (!system_.are_held_triangles_bounded(u, K))
    return {ConeStatus::infeasible, {}, "infeasible: a triangle of three handles folds"};
  std::vector<TriangleTerm> terms;
  terms.reserve(frames_.size());
  for (const Complex& frame : frames_) {
    TriangleTerm& term = terms.emplace_back(system_.energy_term(frame));
    // (k Re(e^{−iθ} f_z), Re f_z̄, Im f_z̄) is in the cone.
    term.R(0, 0) = k * frame.real();
    term.R(0, 1) = k * frame.imag();
    term.R(1, 2) = term.R(2, 3) = 1;
  }
  const ConeSolution solution =
      system_.solver.solve(system_.program(u, handle_positions, terms), tolerance, token);
  switch (solution.status) {
    case ConeStatus::solved: return {solution.status, system_.moved(u, solution.x), ""};
    case ConeStatus::infeasible:
      return {solution.status, {}, "infeasible for these frames (certificate)"};
    case ConeStatus::not_converged: return {solution.status, {}, "a cone program did not converge"};
    case ConeStatus::cancelled: break;
  }
  return {};
}

void BoundedConformal::take_first(Attempt attempt) {
  if (attempt.status != ConeStatus::solved) return end_without_map(attempt, "");
  take(std::move(attempt.u));
  ++updates_;
  energy_ = system_.energy(mesh_.deformed());
  stage_ = Stage::improving;
}

void BoundedConformal::take_move(double lambda, Attempt attempt) {
  if (attempt.status == ConeStatus::solved && !checker_.is_injective(attempt.u)) {
    attempt.status = ConeStatus::not_converged;
    attempt.why = "the maps fold or wind twice";
  }
  if (attempt.status != ConeStatus::solved) {
    lambda_step_ = 0.5 * (lambda - lambda_);
    if (lambda_step_ < kSmallestStep) give_up_path(attempt);
    return;
  }
  take(std::move(attempt.u));
  ++updates_;
  lambda_ = lambda;
  lambda_step_ = std::min(kFirstStep, kStepGrowth * lambda_step_);
  if (lambda < 1) return;
  energy_ = system_.energy(mesh_.deformed());
  stage_ = Stage::improving;
}

// Ends where the farther of the two paths came to.
void BoundedConformal::give_up_path(const Attempt& attempt) {
  HandlePath similar = HandlePath::similar(handle_start(), positions_.targets);
  if (!is_second_path_ && similar.is_similar()) {
    is_second_path_ = true;
    farthest_lambda_ = lambda_;
    farthest_ = mesh_.deformed();
    return begin_path(std::move(similar));
  }
  if (is_second_path_ && farthest_lambda_ > lambda_) {
    lambda_ = farthest_lambda_;
    take(farthest_);
  }
  end_without_map(attempt, " beyond lambda " + lambda_words(lambda_));
}

void BoundedConformal::take_improvement(Attempt attempt) {
  if (attempt.status != ConeStatus::solved)
    return end(Outcome::not_converged, attempt.why + "; the map before stands");
  const double energy = system_.energy(attempt.u);
  const bool gains = energy_ - energy > kEnergyGain * energy_ + kEnergyFloor;
  if (energy > energy_) return end(Outcome::step, words_on(checker_.check(mesh_.deformed())));
  const double turn = take(std::move(attempt.u));
  ++updates_;
  energy_ = energy;
  ++improvements_;
  const int most = std::min(kMostImprovements, parameters_.inner_iterations);
  if (!gains || turn < kFrameChange)
    end(Outcome::step, words_on(checker_.check(mesh_.deformed())));
  else if (improvements_ >= most)
    end(Outcome::iteration_limit, words_on(checker_.check(mesh_.deformed())));
}

double BoundedConformal::take(Points u) {
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

void BoundedConformal::end(Outcome outcome, std::string verdict) {
  outcome_ = outcome;
  verdict_ = std::move(verdict);
}

void BoundedConformal::end_without_map(const Attempt& attempt, const std::string& where) {
  end(attempt.status == ConeStatus::infeasible ? Outcome::infeasible : Outcome::not_converged,
      attempt.why + where);
}

}  // namespace foldless
