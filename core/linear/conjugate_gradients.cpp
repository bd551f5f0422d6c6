// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/conjugate_gradients.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/linear/local_solve.h"

namespace foldless {
namespace {

/// Where no more is asked, the rounding of a preconditioner in single precision does not show.
constexpr double kLeastGainOfSinglePrecision = 1e-5;
/// Of a guess that is nearly in the span of others less than this part of pᵀAp is its own.
constexpr double kLeastOwnPart = 1e-6;

/// After an iteration of length 1 + ε from the matrix's own factor in single precision, the next
/// was measured to gain up to some 20 ε² of what that did.
constexpr double kGainOfSquare = 25;

/// What conjugate gradients have: x, b − A x, and by how much ½xᵀAx − bᵀx is lower than at 0.
struct Progress {
  Eigen::VectorXd x, residual;
  double decrease = 0;
};

/// The best of all sums of multiples of the guesses, which are made conjugate to each other.
Progress best_guess(const SparseSymmetric& A, const Eigen::VectorXd& b,
                    std::span<const Eigen::VectorXd> guesses) {
  Progress progress{Eigen::VectorXd::Zero(b.size()), b};
  struct Direction {
    Eigen::VectorXd p, image;  ///< A p
    double curvature;          ///< pᵀAp
  };
  std::vector<Direction> directions;
  for (const Eigen::VectorXd& guess : guesses) {
    if (guess.size() != b.size()) continue;
    Direction d{guess, Eigen::VectorXd(b.size()), 0};
    multiply(A, d.p, d.image);
    const double whole = d.p.dot(d.image);
    for (const Direction& before : directions) {
      const double part = before.p.dot(d.image) / before.curvature;
      d.p -= part * before.p;
      d.image -= part * before.image;
    }
    d.curvature = d.p.dot(d.image);
    if (!(d.curvature > kLeastOwnPart * whole)) continue;
    const double along = progress.residual.dot(d.p);
    progress.x += along / d.curvature * d.p;
    progress.residual -= along / d.curvature * d.image;
    progress.decrease += 0.5 * along * along / d.curvature;
    directions.push_back(std::move(d));
  }
  return progress;
}

}  // namespace

ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              const Preconditioner& precondition,
                                              const ConjugateGradientSettings& settings) {
  ConjugateGradientSolution solution;
  Progress progress = best_guess(A, b, settings.guesses);
  solution.x = std::move(progress.x);
  Eigen::VectorXd& residual = progress.residual;
  double& decrease = progress.decrease;
  if (settings.local) decrease += settings.local->correct(solution.x, residual);
  const auto preconditioned_residual = [&] {
    Eigen::VectorXd z = precondition(residual);
    if (settings.local) settings.local->make_conjugate(z);
    return z;
  };
  Eigen::VectorXd image(b.size());
  Eigen::VectorXd direction = preconditioned_residual();
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
    const bool is_slow = solution.iterations > 0 && gain > settings.largest_gain * decrease;
    decrease += gain;
    solution.x += length * direction;
    if (gain <= settings.least_gain * decrease) return solution;
    const double missing = length - 1;
    if (settings.is_of_own_factor && kGainOfSquare * missing * missing <= settings.least_gain)
      return solution;
    if (++solution.iterations >= settings.most_iterations || is_slow) {
      solution.end = ConjugateGradientEnd::slow;
      return solution;
    }
    if (settings.token.stop_requested()) {
      solution.end = ConjugateGradientEnd::stopped;
      return solution;
    }
    residual -= length * image;
    const Eigen::VectorXd next = preconditioned_residual();
    const double next_norm = residual.dot(next);
    direction = next + next_norm / norm * direction;
    norm = next_norm;
  }
  if (norm < 0) solution.end = ConjugateGradientEnd::indefinite;
  return solution;
}

ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              Cholesky& factor,
                                              const ConjugateGradientSettings& settings) {
  const bool is_single =
      settings.least_gain >= kLeastGainOfSinglePrecision || factor.precision() == Precision::single;
  const Preconditioner precondition = [&](const Eigen::VectorXd& r) {
    return is_single ? factor.precondition(r) : factor.solve(r);
  };
  ConjugateGradientSettings stoppable = settings;
  stoppable.token = factor.token();
  return conjugate_gradients(A, b, precondition, stoppable);
}

}  // namespace foldless
