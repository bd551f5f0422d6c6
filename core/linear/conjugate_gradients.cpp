// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/linear/local_solve.h"
#include "core/linear/shared_vectors.h"

namespace foldless {
namespace {

/// Where no more is asked, the rounding of a preconditioner in single precision does not show.
constexpr double kLeastGainOfSinglePrecision = 1e-5;
/// Of a guess that is nearly in the span of others less than this part of pᵀAp is its own.
constexpr double kLeastOwnPart = 1e-6;

/// After an iteration of length 1 + ε from the matrix's own factor in single precision, the next
/// was measured to gain up to some 20 ε² of what that did.
constexpr double kGainOfSquare = 25;

/// Takes the best of all sums of multiples of the guesses, which are made conjugate to each other,
/// for x, and off the residual b − A x; by how much ½xᵀAx − bᵀx is then lower than at x = 0.
double take_best_guess(const SparseSymmetric& A, std::span<const Eigen::VectorXd> guesses,
                       Eigen::VectorXd& x, ConjugateGradientRoom& room) {
  double decrease = 0;
  std::size_t count = 0;
  room.guesses.resize(std::max(room.guesses.size(), guesses.size()));
  for (const Eigen::VectorXd& guess : guesses) {
    if (guess.size() != x.size()) continue;
    auto& [p, image, curvature] = room.guesses[count];
    p = guess;
    multiply(A, p, image);
    const double whole = shared_dot(p, image);
    for (std::size_t k = 0; k < count; ++k) {
      const ConjugateGradientRoom::Direction& before = room.guesses[k];
      const double part = shared_dot(before.p, image) / before.curvature;
      add_multiple(-part, before.p, p);
      add_multiple(-part, before.image, image);
    }
    curvature = shared_dot(p, image);
    if (!(curvature > kLeastOwnPart * whole)) continue;
    const double along = shared_dot(room.residual, p);
    add_multiple(along / curvature, p, x);
    add_multiple(-along / curvature, image, room.residual);
    decrease += 0.5 * along * along / curvature;
    ++count;
  }
  return decrease;
}

}  // namespace

ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              const Preconditioner& precondition,
                                              const ConjugateGradientSettings& settings) {
  ConjugateGradientRoom own;
  ConjugateGradientRoom& room = settings.room ? *settings.room : own;
  Eigen::VectorXd &residual = room.residual, &direction = room.direction;
  ConjugateGradientSolution solution{Eigen::VectorXd::Zero(b.size())};
  residual = b;
  double decrease = take_best_guess(A, settings.guesses, solution.x, room);
  if (settings.local) decrease += settings.local->correct(solution.x, residual);
  const auto preconditioned_residual = [&] {
    Eigen::VectorXd z = precondition(residual);
    if (settings.local) settings.local->make_conjugate(z);
    return z;
  };
  direction = preconditioned_residual();
  double norm = shared_dot(residual, direction);
  while (!(norm <= 0)) {
    multiply(A, direction, room.image);
    const double curvature = shared_dot(direction, room.image);
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
    add_multiple(length, direction, solution.x);
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
    add_multiple(-length, room.image, residual);
    Eigen::VectorXd next = preconditioned_residual();
    const double next_norm = shared_dot(residual, next);
    add_multiple(next_norm / norm, direction, next);
    std::swap(direction, next);
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
