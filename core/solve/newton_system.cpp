// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

#include "core/solve/conjugate_gradients.h"

namespace foldless {
namespace {

// The damping of [SKPSH13].
constexpr double kLambdaAfterSuccess = 1e-5;
constexpr double kLambdaFactor = 10;
constexpr double kLargestLambda = 1e17;

/// Of a small system. One of so many unknowns is ordered anew whenever an edge has changed: a few
/// hundred flips under an old ordering were measured to treble the time of its factorization.
constexpr double kEdgesChangedBeforeReordering = 0.02;
constexpr int kReorderedFrom = 2000;

/// An iteration costs a tenth of a factorization or less.
constexpr int kMostLaggedIterations = 8;
/// A factor that took so many iterations is too far from ∇²E to serve once more.
constexpr int kIterationsOfAFarFactor = 5;
constexpr double kLeastGain = 1e-2;
/// Where handles are carried there is no line search that would mend a rough step.
constexpr double kLeastGainOfACarry = 1e-3;

}  // namespace

NewtonSystem::NewtonSystem(const EnergySettings& settings, const MeshPair& mesh,
                           const Positions& positions)
    : objective_(settings, mesh, positions), edge_count_(mesh.edge_count()) {}

void NewtonSystem::rebuild(const MeshPair& mesh, const Positions& positions, int changed_edges) {
  StageTimer timer(times.analyze);
  objective_ = Objective(objective_.settings(), mesh, positions);
  is_factor_near_ = false;
  take_pattern(mesh, changed_edges);
}

void NewtonSystem::take_flips(const MeshPair& mesh, int flips) {
  StageTimer timer(times.analyze);
  objective_.take_flips(mesh);
  take_pattern(mesh, flips);
}

void NewtonSystem::take_pattern(const MeshPair& mesh, int changed_edges) {
  has_pattern_ = false;
  edge_count_ = mesh.edge_count();
  edges_changed_since_ordering_ += changed_edges;
  pattern_analyzed_ = false;
  plain_factor_ = false;
}

void NewtonSystem::set_energy(const EnergySettings& settings, const MeshPair& mesh,
                              const Positions& positions) {
  objective_ = Objective(settings, mesh, positions);
  plain_factor_ = false;
  is_factor_near_ = false;
}

void NewtonSystem::assemble(const Points& u, const Positions& positions, double clamping) {
  if (!has_pattern_) {
    StageTimer timer(times.analyze);
    hessian_ = objective_.hessian_pattern();
    has_pattern_ = true;
  }
  StageTimer timer(times.assemble);
  first_order_ = objective_.assemble(u, positions, hessian_, clamping);
  is_held_ = positions.held;
  plain_factor_ = false;
}

void NewtonSystem::assemble_gradient(const Points& u, const Positions& positions) {
  StageTimer timer(times.assemble);
  first_order_ = objective_.gradient(u, positions);
}

bool NewtonSystem::factorize(double mu) {
  if (!pattern_analyzed_) {
    StageTimer timer(times.analyze);
    const bool keep =
        edges_changed_since_ordering_ == 0 ||
        (hessian_.size() < kReorderedFrom &&
         edges_changed_since_ordering_ <= kEdgesChangedBeforeReordering * edge_count_);
    if (!keep) edges_changed_since_ordering_ = 0;
    cholesky_.analyze(hessian_, keep);
    pattern_analyzed_ = true;
  }
  StageTimer timer(times.factorize);
  ++counters.factorizations;
  is_factor_near_ = cholesky_.factorize(hessian_, mu);
  is_factor_held_ = is_held_;
  return is_factor_near_;
}

bool NewtonSystem::factorize_plain() {
  plain_factor_ = factorize(0);
  if (!plain_factor_) return false;
  lambda_ = kLambdaAfterSuccess;
  return true;
}

std::optional<double> NewtonSystem::factorize_damped(bool plain_failed, std::stop_token token) {
  if (!plain_failed && factorize_plain()) return 0;
  double mu = 0;
  for (bool first = true; lambda_ <= kLargestLambda; first = false) {
    if (token.stop_requested()) return std::nullopt;
    mu += lambda_;
    plain_factor_ = false;
    if (factorize(mu)) {
      if (first) lambda_ /= kLambdaFactor;
      return mu;
    }
    lambda_ *= kLambdaFactor;
  }
  return std::nullopt;
}

Points NewtonSystem::newton_step() {
  StageTimer timer(times.solve);
  return objective_.spread(cholesky_.solve(-gradient()));
}

Points NewtonSystem::carrying_step(const Points& u, const Points& way) {
  StageTimer timer(times.solve);
  const Eigen::VectorXd pull = objective_.pull_of_handles(u, way);
  return objective_.spread(cholesky_.solve(-gradient() - pull)) + way;
}

bool NewtonSystem::may_lag() const {
  return is_lagging_ && is_factor_near_ && cholesky_.has_factor() && is_held_ == is_factor_held_;
}

std::optional<LaggedStep> NewtonSystem::lagged_newton_step() {
  return lagged_step(-gradient(), kLeastGain);
}

std::optional<LaggedStep> NewtonSystem::lagged_carrying_step(const Points& u, const Points& way) {
  if (!may_lag()) return std::nullopt;
  const Eigen::VectorXd pull = objective_.pull_of_handles(u, way);
  std::optional<LaggedStep> lagged = lagged_step(-gradient() - pull, kLeastGainOfACarry);
  if (lagged && !lagged->is_indefinite) lagged->step += way;
  return lagged;
}

std::optional<LaggedStep> NewtonSystem::lagged_step(const Eigen::VectorXd& right_hand_side,
                                                    double least_gain) {
  if (!may_lag()) return std::nullopt;
  StageTimer timer(times.solve);
  const ConjugateGradientSolution solution = conjugate_gradients(
      hessian_, right_hand_side, cholesky_, {least_gain, kMostLaggedIterations});
  is_factor_near_ = solution.iterations < kIterationsOfAFarFactor;
  if (solution.end == ConjugateGradientEnd::slow) return std::nullopt;
  if (solution.end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{objective_.spread(solution.x), false};
}

double NewtonSystem::slope(const Points& step) const {
  double sum = 0;
  const std::vector<int>& vertices = objective_.unknowns().vertex_of_node;
  for (std::size_t node = 0; node < vertices.size(); ++node)
    sum += gradient().segment<2>(2 * static_cast<Eigen::Index>(node)).dot(step.col(vertices[node]));
  return sum;
}

}  // namespace foldless
