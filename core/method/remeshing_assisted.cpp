// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/remeshing_assisted.h"

#include <cmath>
#include <limits>

#include "core/method/moving_directions.h"
#include "core/method/record.h"
#include "core/method/satisfied.h"
#include "core/solve/relax_vertices.h"

namespace foldless {
namespace {

/// A round that leaves more of ‖P‖² than this has stopped gaining.
constexpr double kGainOfARound = 0.9;
/// No split makes an edge shorter than this. [D]
constexpr double kShortestEdge = 1e-5;

double mean_rest_area(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(mesh.rest(), t);
  return sum / mesh.face_count();
}

/// A watch of some updates: without it a blocked inner loop creeps on for N_in repeats before the
/// edges that block it are split.
class Watch {
 public:
  bool has_stalled(int inner, double error) {
    constexpr double kGain = 0.9;
    constexpr int kUpdates = 50;
    if (inner % kUpdates != 0) return false;
    const bool stalled = error > kGain * watched_error_;
    watched_error_ = error;
    return stalled;
  }

 private:
  double watched_error_ = std::numeric_limits<double>::infinity();  ///< ‖P‖² when it began
};

/// The best end of a round of splits. Unchecked, a blocked scene grows slivers without end: rounds
/// that gained nothing on the targets are undone.
class BestRound {
 public:
  /// False when that was one round too many that gained nothing.
  bool is_gaining(const MeshPair& mesh, double error) {
    constexpr int kMostRoundsWithoutGain = 1;
    const bool gained = !mesh_ || error < kGainOfARound * error_;
    rounds_without_gain_ = gained ? 0 : rounds_without_gain_ + 1;
    if (!mesh_ || error < error_) {
      mesh_ = mesh;
      error_ = error;
    }
    return rounds_without_gain_ <= kMostRoundsWithoutGain;
  }
  const MeshPair& mesh() const { return *mesh_; }
  double error() const { return error_; }

 private:
  std::optional<MeshPair> mesh_;
  double error_ = 0;  ///< ‖P‖²
  int rounds_without_gain_ = 0;
};

}  // namespace

EnergySettings energy_settings(const Problem& problem) {
  const Parameters& p = problem.parameters;
  const double diagonal = bounding_box_diagonal(problem.mesh.rest());
  EnergySettings settings{.density = problem.energy,
                          .alpha = p.alpha,
                          .beta = p.beta.value_or(problem.energy->default_beta),
                          .delta = p.delta};
  settings.unit_area = diagonal * diagonal;
  settings.area_weighted = !problem.energy->paper_sums_unweighted || p.area_weighted;
  const bool was_unweighted = problem.energy->paper_sums_unweighted && p.area_weighted;
  settings.beta *= was_unweighted ? mean_rest_area(problem.mesh) : settings.unit_area;
  return settings;
}

double gradient_tolerance(const Parameters& parameters, double diagonal) {
  return parameters.gradient_tolerance * diagonal * diagonal;
}

RemeshingAssisted::RemeshingAssisted(const Problem& problem, Remeshing remeshing)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      remeshing_(remeshing),
      diagonal_(bounding_box_diagonal(mesh_.rest())),
      energy_{energy_settings(problem), constraints_of(problem.handles)},
      system_(mesh_, energy_.constraints, effort()) {
  begin(algorithm_1());
}

void RemeshingAssisted::set_targets(const Points& targets) {
  energy_.constraints.targets = targets;
  begin(algorithm_1());
}

// Without splits another round only begins where the one before ended: it can help when the last
// step was too small, or after N_in repeats that were still gaining on the targets.
Steps<Outcome> RemeshingAssisted::algorithm_1() {
  BestRound best;
  for (int outer = 0;; ++outer) {
    const double error_before = error();
    const RoundEnd round = co_await inner_loop(outer);
    if (is_satisfied()) co_return round.outcome;
    if (remeshing_.splits && !best.is_gaining(mesh_, error())) {
      if (best.error() < error()) {
        go_back_to(best.mesh());
        co_yield [this](Iteration& last) { measure(last, system_, mesh_, energy_); };
      }
      co_return round.outcome;
    }
    if (outer + 1 >= parameters_.outer_iterations) co_return round.outcome;
    bool goes_on = false;
    if (remeshing_.splits)
      goes_on = split(round) > 0;
    else if (round.outcome == Outcome::step)
      goes_on = round.has_changed_mesh;
    else if (round.outcome == Outcome::iteration_limit)
      goes_on = error() < kGainOfARound * error_before;
    if (!goes_on) co_return round.outcome;
  }
}

// Lines 3 to 9.
Steps<RemeshingAssisted::RoundEnd> RemeshingAssisted::inner_loop(int outer) {
  RoundEnd round;
  Watch watch;
  const auto next = [this](const std::stop_token& token) {
    return update_vertices(system_, mesh_, energy_, token);
  };
  for (int inner = 1;; ++inner) {
    round.handles_before = handle_positions(energy_.constraints, mesh_.deformed());
    const VertexUpdate update = co_await vertex_update(next);
    round.is_last_step_small = is_small(update);
    if (!round.is_last_step_small) round.has_changed_mesh = true;
    system_.assemble_gradient(energy_, mesh_.deformed());
    std::optional<Outcome> ended = convergence(update);
    co_await Pause();
    if (!ended && flip() > 0) {
      round.has_changed_mesh = true;
      co_await Pause();
      system_.assemble_gradient(energy_, mesh_.deformed());
    }
    const bool is_limit_reached = inner >= parameters_.inner_iterations ||
                                  (remeshing_.splits && watch.has_stalled(inner, error()));
    if (!ended && is_limit_reached) ended = Outcome::iteration_limit;
    Iteration iteration = record(update, Phase::update);
    iteration.outer = outer;
    iteration.inner = inner;
    co_yield iteration;
    if (ended) {
      round.outcome = *ended;
      co_return round;
    }
    const bool has_relaxed = co_await relax(outer, inner);
    if (has_relaxed) round.has_changed_mesh = true;
  }
}

// Until ∇²E is positive definite, whose factor serves the next update, or no vertex moves any more.
Steps<bool> RemeshingAssisted::relax(int outer, int inner) {
  const auto next = [this](const std::stop_token& token) {
    return relax_vertices(system_, mesh_, energy_, token);
  };
  for (bool has_moved = false;; has_moved = true) {
    const std::optional<VertexUpdate> relaxed = co_await vertex_update(next);
    if (!relaxed) co_return has_moved;
    system_.assemble_gradient(energy_, mesh_.deformed());
    Iteration iteration = record(*relaxed, Phase::relax);
    iteration.outer = outer;
    iteration.inner = inner;
    co_yield iteration;
    if (is_small(*relaxed)) co_return has_moved;
  }
}

std::optional<Outcome> RemeshingAssisted::convergence(const VertexUpdate& update) const {
  if (is_gradient_small()) return Outcome::gradient;
  if (is_small(update)) return Outcome::step;
  return std::nullopt;
}

// Eq. 7.
bool RemeshingAssisted::is_gradient_small() const {
  return system_.gradient().squaredNorm() < gradient_tolerance(parameters_, diagonal_);
}

// Eq. 8.
bool RemeshingAssisted::is_small(const VertexUpdate& update) const {
  return update.step_infinity_norm < parameters_.step_tolerance * diagonal_;
}

bool RemeshingAssisted::is_satisfied() const {
  return error() <= kSatisfied * diagonal_ * diagonal_;
}

double RemeshingAssisted::error() const {
  return handle_error_squared(energy_.constraints, mesh_.deformed());
}

int RemeshingAssisted::flip() {
  if (!remeshing_.flips) return 0;
  int flips = 0;
  {
    StageTimer timer(effort().times.flip);
    flips = flip_edges(mesh_, {energy_.settings, parameters_.eta, parameters_.condition_test});
  }
  if (flips > 0) system_.follow_flips(mesh_);
  effort().flips += flips;
  return flips;
}

int RemeshingAssisted::split(const RoundEnd& round) {
  const double off_target = std::sqrt(kSatisfied / energy_.constraints.count()) * diagonal_;
  const auto directions = moving_directions(
      energy_.constraints, mesh_.deformed(),
      {round.outcome, round.is_last_step_small, round.handles_before, system_.gradient()},
      off_target);
  const int splits = split_edges(
      mesh_, directions, {.shortest_edge = kShortestEdge * diagonal_, .delta = parameters_.delta});
  if (splits > 0) system_.rebuild(mesh_, energy_.constraints);
  effort().splits += splits;
  return splits;
}

void RemeshingAssisted::go_back_to(const MeshPair& mesh) {
  mesh_ = mesh;
  system_.rebuild(mesh_, energy_.constraints);
  system_.assemble_gradient(energy_, mesh_.deformed());
}

Iteration RemeshingAssisted::record(const VertexUpdate& update, Phase phase) const {
  Iteration iteration = record_of(update, system_, mesh_, energy_);
  iteration.phase = phase;
  return iteration;
}

}  // namespace foldless
