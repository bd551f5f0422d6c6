// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

namespace foldless {
namespace {

// The damping of [SKPSH13].
constexpr double kFirstLambda = 0.1;
constexpr double kLambdaAfterSuccess = 1e-5;
constexpr double kLambdaFactor = 10;
constexpr double kLargestLambda = 1e17;

constexpr double kLeastGain = 1e-2;
/// Where handles are carried there is no line search that would mend a rough step.
constexpr double kLeastGainOfACarry = 1e-3;

}  // namespace

NewtonSystem::NewtonSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort)
    : effort_(&effort), objective_(mesh, constraints), lambda_(kFirstLambda) {
  factor_.outdate_pattern(mesh.edge_count(), 0);
}

void NewtonSystem::rebuild(const MeshPair& mesh, const Constraints& constraints,
                           int changed_edges) {
  StageTimer timer(effort_->times.analyze);
  objective_ = Objective(mesh, constraints);
  factor_.set_far();
  outdate_pattern(mesh, changed_edges);
}

void NewtonSystem::follow_flips(const MeshPair& mesh, int flips) {
  StageTimer timer(effort_->times.analyze);
  objective_.follow_flips(mesh);
  outdate_pattern(mesh, flips);
}

void NewtonSystem::outdate_pattern(const MeshPair& mesh, int changed_edges) {
  has_pattern_ = false;
  factor_.outdate_pattern(mesh.edge_count(), changed_edges);
}

void NewtonSystem::assemble(const Energy& energy, const Points& u, double clamping) {
  if (!has_pattern_) {
    StageTimer timer(effort_->times.analyze);
    hessian_.matrix = objective_.hessian_pattern();
    has_pattern_ = true;
  }
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.assemble(energy, u, hessian_.matrix, clamping);
  const EnergySettings& settings = energy.settings;
  hessian_.kind = {settings.density, settings.beta, settings.reference, energy.constraints.held};
  factor_.outdate();
}

void NewtonSystem::assemble_gradient(const Energy& energy, const Points& u) {
  StageTimer timer(effort_->times.assemble);
  first_order_ = objective_.gradient(energy, u);
}

void NewtonSystem::analyze() {
  StageTimer timer(effort_->times.analyze);
  factor_.analyze(hessian_.matrix);
}

bool NewtonSystem::factorize(double mu) {
  analyze();
  StageTimer timer(effort_->times.factorize);
  ++effort_->factorizations;
  return factor_.factorize(hessian_, mu);
}

bool NewtonSystem::factorize_plain() {
  if (!factorize(0)) return false;
  lambda_ = kLambdaAfterSuccess;
  return true;
}

std::optional<double> NewtonSystem::factorize_damped(bool plain_failed,
                                                     const std::stop_token& token) {
  analyze();
  if (token.stop_requested()) return std::nullopt;
  if (!plain_failed && factorize_plain()) return 0;
  double mu = 0;
  for (bool first = true; lambda_ <= kLargestLambda; first = false) {
    if (token.stop_requested()) return std::nullopt;
    mu += lambda_;
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
  return factor_.solve(-gradient()).reshaped(2, gradient().size() / 2);
}

Points NewtonSystem::carrying_step(const EnergySettings& settings, const Points& u,
                                   const Points& way) {
  StageTimer timer(effort_->times.solve);
  const Eigen::VectorXd pull = objective_.pull_of_handles(settings, u, way);
  return factor_.solve(-gradient() - pull).reshaped(2, way.cols()) + way;
}

std::optional<LaggedStep> NewtonSystem::lagged_newton_step() {
  return lagged_step(-gradient(), kLeastGain);
}

std::optional<LaggedStep> NewtonSystem::lagged_carrying_step(const EnergySettings& settings,
                                                             const Points& u, const Points& way) {
  if (!factor_.is_near(hessian_.kind)) return std::nullopt;
  const Eigen::VectorXd pull = objective_.pull_of_handles(settings, u, way);
  std::optional<LaggedStep> lagged = lagged_step(-gradient() - pull, kLeastGainOfACarry);
  if (lagged && !lagged->is_indefinite) lagged->step += way;
  return lagged;
}

std::optional<LaggedStep> NewtonSystem::lagged_step(const Eigen::VectorXd& right_hand_side,
                                                    double least_gain) {
  StageTimer timer(effort_->times.solve);
  const auto solution = factor_.solve_later(hessian_, right_hand_side, least_gain);
  if (!solution) return std::nullopt;
  if (solution->end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{solution->x.reshaped(2, solution->x.size() / 2), false};
}

double NewtonSystem::slope(const Points& step) const {
  double sum = 0;
  for (Eigen::Index v = 0; v < step.cols(); ++v)
    sum += gradient().segment<2>(2 * v).dot(step.col(v));
  return sum;
}

}  // namespace foldless
