// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_step.h"

#include <span>
#include <utility>

namespace foldless {
namespace {

constexpr double kLeastGain = 1e-2;
/// Where handles are carried there is no line search that would mend a rough step, and after good
/// guesses little gain does not say that little is left.
constexpr double kLeastGainOfACarry = 3e-5;

std::optional<LaggedStep> lagged_step(NewtonSystem& system, const Eigen::VectorXd& right_hand_side,
                                      double least_gain,
                                      std::span<const Eigen::VectorXd> guesses = {}) {
  StageTimer timer(system.effort().times.solve);
  const auto solution =
      system.factor().solve_later(system.hessian(), right_hand_side, least_gain, guesses);
  if (!solution) return std::nullopt;
  if (solution->end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{solution->x.reshaped(2, solution->x.size() / 2), false};
}

}  // namespace

void analyze(NewtonSystem& system) {
  StageTimer timer(system.effort().times.analyze);
  system.factor().analyze(system.hessian().matrix);
}

bool factorize(NewtonSystem& system, double mu, Precision precision) {
  analyze(system);
  StageTimer timer(system.effort().times.factorize);
  ++system.effort().factorizations;
  return system.factor().factorize(system.hessian(), mu, precision);
}

Points newton_step(NewtonSystem& system) {
  StageTimer timer(system.effort().times.solve);
  const Eigen::VectorXd& gradient = system.gradient();
  return system.factor().solve(-gradient).reshaped(2, gradient.size() / 2);
}

Points carrying_step(NewtonSystem& system, const EnergySettings& settings, const Points& u,
                     const Points& way) {
  StageTimer timer(system.effort().times.solve);
  const Eigen::VectorXd pull = system.objective().pull_of_handles(settings, u, way);
  Eigen::VectorXd following = system.factor().solve(-system.gradient() - pull);
  Points step = following.reshaped(2, way.cols()) + way;
  system.has_followed(std::move(following));
  return step;
}

std::optional<LaggedStep> lagged_newton_step(NewtonSystem& system) {
  return lagged_step(system, -system.gradient(), kLeastGain);
}

std::optional<LaggedStep> lagged_carrying_step(NewtonSystem& system, const EnergySettings& settings,
                                               const Points& u, const Points& way) {
  if (!system.factor().is_near(system.hessian().kind)) return std::nullopt;
  const Eigen::VectorXd pull = system.objective().pull_of_handles(settings, u, way);
  std::optional<LaggedStep> lagged =  // a drag goes on much as it went
      lagged_step(system, -system.gradient() - pull, kLeastGainOfACarry, system.followings());
  if (!lagged || lagged->is_indefinite) return lagged;
  system.has_followed(lagged->step.reshaped());
  lagged->step += way;
  return lagged;
}

double slope(const NewtonSystem& system, const Points& step) {
  double sum = 0;
  for (Eigen::Index v = 0; v < step.cols(); ++v)
    sum += system.gradient().segment<2>(2 * v).dot(step.col(v));
  return sum;
}

}  // namespace foldless
