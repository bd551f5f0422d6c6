// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

#include "core/linear/conjugate_gradients.h"

namespace foldless {
namespace {

// The damping of [SKPSH13].
constexpr double kFirstLambda = 0.1;
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

NewtonSystem::NewtonSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort)
    : effort_(&effort),
      objective_(mesh, constraints),
      edge_count_(mesh.edge_count()),
      lambda_(kFirstLambda) {}

void NewtonSystem::rebuild(const MeshPair& mesh, const Constraints& constraints,
                           int changed_edges) {
  StageTimer timer(effort_->times.analyze);
  objective_ = Objective(mesh, constraints);
  is_factor_near_ = false;
  outdate_pattern(mesh, changed_edges);
}

void NewtonSystem::follow_flips(const MeshPair& mesh, int flips) {
  StageTimer timer(effort_->times.analyze);
  objective_.follow_flips(mesh);
  outdate_pattern(mesh, flips);
}

void NewtonSystem::outdate_pattern(const MeshPair& mesh, int changed_edges) {
  has_pattern_ = false;
  edge_count_ = mesh.edge_count();
  edges_changed_since_ordering_ += changed_edges;
  pattern_analyzed_ = false;
  plain_factor_ = false;
}

void NewtonSystem::assemble(const Energy& energy, const Points& u, double clamping) {
  if (!has_pattern_) {
    StageTimer timer(effort_->times.analyze);
    hessian_ = objective_.hessian_pattern();
    has_pattern_ = true;
  }
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.assemble(energy, u, hessian_, clamping);
  const EnergySettings& settings = energy.settings;
  kind_ = {settings.density, settings.beta, settings.reference, energy.constraints.held};
  plain_factor_ = false;
}

void NewtonSystem::assemble_gradient(const Energy& energy, const Points& u) {
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.gradient(energy, u);
}

void NewtonSystem::analyze() {
  StageTimer timer(effort_->times.analyze);
  const bool keep =
      edges_changed_since_ordering_ == 0 ||
      (hessian_.size() < kReorderedFrom &&
       edges_changed_since_ordering_ <= kEdgesChangedBeforeReordering * edge_count_);
  if (!keep) edges_changed_since_ordering_ = 0;
  cholesky_.analyze(hessian_, keep);
  pattern_analyzed_ = true;
}

bool NewtonSystem::factorize(double mu) {
  if (!pattern_analyzed_) analyze();
  StageTimer timer(effort_->times.factorize);
  ++effort_->factorizations;
  is_factor_near_ = cholesky_.factorize(hessian_, mu);
  kind_of_factor_ = kind_;
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
  lambda_ = kFirstLambda;
  return std::nullopt;
}

Points NewtonSystem::newton_step() {
  StageTimer timer(effort_->times.solve);
  return cholesky_.solve(-gradient()).reshaped(2, gradient().size() / 2);
}

Points NewtonSystem::carrying_step(const EnergySettings& settings, const Points& u,
                                   const Points& way) {
  StageTimer timer(effort_->times.solve);
  const Eigen::VectorXd pull = objective_.pull_of_handles(settings, u, way);
  return cholesky_.solve(-gradient() - pull).reshaped(2, way.cols()) + way;
}

bool NewtonSystem::is_factor_near() const {
  return is_factor_near_ && cholesky_.has_factor() && kind_ == kind_of_factor_;
}

std::optional<LaggedStep> NewtonSystem::lagged_newton_step() {
  return lagged_step(-gradient(), kLeastGain);
}

std::optional<LaggedStep> NewtonSystem::lagged_carrying_step(const EnergySettings& settings,
                                                             const Points& u, const Points& way) {
  if (!is_factor_near()) return std::nullopt;
  const Eigen::VectorXd pull = objective_.pull_of_handles(settings, u, way);
  std::optional<LaggedStep> lagged = lagged_step(-gradient() - pull, kLeastGainOfACarry);
  if (lagged && !lagged->is_indefinite) lagged->step += way;
  return lagged;
}

std::optional<LaggedStep> NewtonSystem::lagged_step(const Eigen::VectorXd& right_hand_side,
                                                    double least_gain) {
  if (!is_factor_near()) return std::nullopt;
  StageTimer timer(effort_->times.solve);
  const ConjugateGradientSolution solution = conjugate_gradients(
      hessian_, right_hand_side, cholesky_, {least_gain, kMostLaggedIterations});
  is_factor_near_ = solution.iterations < kIterationsOfAFarFactor;
  if (solution.end == ConjugateGradientEnd::slow) return std::nullopt;
  if (solution.end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{solution.x.reshaped(2, solution.x.size() / 2), false};
}

double NewtonSystem::slope(const Points& step) const {
  double sum = 0;
  for (Eigen::Index v = 0; v < step.cols(); ++v)
    sum += gradient().segment<2>(2 * v).dot(step.col(v));
  return sum;
}

}  // namespace foldless
