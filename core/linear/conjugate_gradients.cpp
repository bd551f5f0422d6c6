// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/conjugate_gradients.h"

#include <cmath>

namespace foldless {
namespace {

/// Where no more is asked, the rounding of a preconditioner in single precision does not show.
constexpr double kLeastGainOfSinglePrecision = 1e-4;

}  // namespace

ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              Cholesky& factor,
                                              const ConjugateGradientSettings& settings) {
  ConjugateGradientSolution solution{Eigen::VectorXd::Zero(b.size())};
  const bool is_single =
      settings.least_gain >= kLeastGainOfSinglePrecision || factor.precision() == Precision::single;
  const auto precondition = [&](const Eigen::VectorXd& r) {
    return is_single ? factor.precondition(r) : factor.solve(r);
  };
  Eigen::VectorXd residual = b;
  Eigen::VectorXd image(b.size());
  double decrease = 0;
  if (settings.guess && settings.guess->size() == b.size()) {
    const Eigen::VectorXd& guess = *settings.guess;
    multiply(A, guess, image);
    const double along = b.dot(guess), curvature = guess.dot(image);
    if (along > 0 && curvature > 0) {
      const double length = along / curvature;
      solution.x = length * guess;
      residual -= length * image;
      decrease = 0.5 * length * along;
    }
  }
  Eigen::VectorXd direction = precondition(residual);
  double norm = residual.dot(direction);
  while (!(norm <= 0)) {
    multiply(A, direction, image);
    const double curvature = direction.dot(image);
    if (!std::isfinite(curvature)) {  // the preconditioner's numbers ended
      solution.end = ConjugateGradientEnd::slow;
      return solution;
    }
    if (!(curvature > 0)) {
      solution.end = ConjugateGradientEnd::indefinite;
      return solution;
    }
    const double length = norm / curvature;
    const double gain = 0.5 * length * norm;
    decrease += gain;
    solution.x += length * direction;
    if (gain <= settings.least_gain * decrease) return solution;
    if (++solution.iterations >= settings.most_iterations) {
      solution.end = ConjugateGradientEnd::slow;
      return solution;
    }
    if (factor.is_stopped()) {
      solution.end = ConjugateGradientEnd::stopped;
      return solution;
    }
    residual -= length * image;
    const Eigen::VectorXd next = precondition(residual);
    const double next_norm = residual.dot(next);
    direction = next + next_norm / norm * direction;
    norm = next_norm;
  }
  return solution;
}

}  // namespace foldless
