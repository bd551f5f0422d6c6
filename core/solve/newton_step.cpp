// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_step.h"

#include <span>
#include <utility>

#include "core/linear/shared_vectors.h"

namespace foldless {
namespace {

constexpr double kLeastGain = 1e-2;
/// Where handles are carried there is no line search that would mend a rough step, and after good
/// guesses little gain does not say that little is left.
constexpr double kLeastGainOfACarry = 3e-5;

std::optional<ConjugateGradientSolution> solve_later(NewtonSystem& system,
                                                     const Eigen::VectorXd& right_hand_side,
                                                     double least_gain,
                                                     std::span<const Eigen::VectorXd> guesses) {
  StageTimer timer(system.effort().times.solve);
  return system.factor().solve_later(system.hessian(), right_hand_side, least_gain, guesses);
}

/// −∇E − pull
Eigen::VectorXd without_gradient(const NewtonSystem& system, Eigen::VectorXd pull) {
  const Eigen::VectorXd& gradient = system.gradient();
  in_ranges(pull.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    pull.segment(begin, end - begin) =
        -gradient.segment(begin, end - begin) - pull.segment(begin, end - begin);
  });
  return pull;
}

/// How the vertices follow, and the step that they and the handles make together.
Points with_handles(NewtonSystem& system, Eigen::VectorXd following, const Points& way) {
  Points step(2, way.cols());
  in_ranges(step.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    step.reshaped().segment(begin, end - begin) =
        following.segment(begin, end - begin) + way.reshaped().segment(begin, end - begin);
  });
  system.has_followed(std::move(following));
  return step;
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
  Eigen::VectorXd pull = system.objective().pull_of_handles(settings, u, way);
  const Eigen::VectorXd right_hand_side = without_gradient(system, std::move(pull));
  return with_handles(system, system.factor().solve(right_hand_side), way);
}

std::optional<LaggedStep> lagged_newton_step(NewtonSystem& system) {
  const auto solution = solve_later(system, -system.gradient(), kLeastGain, {});
  if (!solution) return std::nullopt;
  if (solution->end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{solution->x.reshaped(2, solution->x.size() / 2), false};
}

std::optional<LaggedStep> lagged_carrying_step(NewtonSystem& system, const EnergySettings& settings,
                                               const Points& u, const Points& way) {
  if (!system.factor().is_near(system.hessian().kind)) return std::nullopt;
  Eigen::VectorXd pull = system.objective().pull_of_handles(settings, u, way);
  auto solution = solve_later(  // a drag goes on much as it went
      system, without_gradient(system, std::move(pull)), kLeastGainOfACarry, system.followings());
  if (!solution) return std::nullopt;
  if (solution->end == ConjugateGradientEnd::indefinite) return LaggedStep{{}, true};
  return LaggedStep{with_handles(system, std::move(solution->x), way), false};
}

double slope(const NewtonSystem& system, const Points& step) {
  double sum = 0;
  for (Eigen::Index v = 0; v < step.cols(); ++v)
    sum += system.gradient().segment<2>(2 * v).dot(step.col(v));
  return sum;
}

}  // namespace foldless
