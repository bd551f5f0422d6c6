// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/linear/local_solve.h"
#include "core/linear/shared_vectors.h"
#include "core/threads/team.h"
#include "core/threads/values_of_ranges.h"
#include "core/threads/zeros.h"

namespace foldless {
namespace {

/// Where no more is asked, the rounding of a preconditioner in single precision does not show.
constexpr double kLeastGainOfSinglePrecision = 1e-5;
/// Of a guess that is nearly in the span of others less than this part of pᵀAp is its own.
constexpr double kLeastOwnPart = 1e-6;

/// Some vectors p, their images A p, and a residual r.
struct Guesses {
  std::vector<const Eigen::VectorXd*> p;
  const std::vector<Eigen::VectorXd>& images;
  const Eigen::VectorXd& residual;
};

/// pᵢᵀApⱼ in columns j, and pᵢᵀr in the last one.
Eigen::MatrixXd products_of(const Guesses& of) {
  const auto count = static_cast<Eigen::Index>(of.p.size());
  const auto in_range = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    const auto part = [&](const Eigen::VectorXd& all) { return all.segment(begin, end - begin); };
    Eigen::MatrixXd products(count, count + 1);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto p = part(*of.p[static_cast<std::size_t>(i)]);
      for (Eigen::Index j = 0; j < count; ++j)
        products(i, j) = p.dot(part(of.images[static_cast<std::size_t>(j)]));
      products(i, count) = p.dot(part(of.residual));
    }
    return products;
  };
  const auto ranges = values_of_ranges(of.residual.size(), kEntriesTogether, in_range);
  return std::accumulate(ranges.begin(), ranges.end(),
                         Eigen::MatrixXd(Eigen::MatrixXd::Zero(count, count + 1)));
}

/// A sum of multiples of guesses, and by how much ½xᵀAx − bᵀx is lower there than where r is of.
struct BestGuess {
  Eigen::VectorXd multiples;
  double decrease = 0;
};

/// The guesses are made conjugate to each other, as sums of multiples of them.
BestGuess best_guess(const Eigen::MatrixXd& products) {
  const Eigen::Index count = products.rows();
  BestGuess best{Eigen::VectorXd::Zero(count)};
  std::vector<Eigen::VectorXd> conjugate, images;  // images: qᵀA pⱼ by j, over qᵀAq
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::VectorXd q = Eigen::VectorXd::Unit(count, k);
    for (std::size_t m = 0; m < conjugate.size(); ++m) q -= images[m][k] * conjugate[m];
    Eigen::VectorXd image = q.transpose() * products.leftCols(count);
    const double curvature = image.dot(q);
    if (!(curvature > kLeastOwnPart * products(k, k))) continue;
    const double along = q.dot(products.col(count));
    best.multiples += along / curvature * q;
    best.decrease += 0.5 * along * along / curvature;
    conjugate.push_back(std::move(q));
    images.push_back(image / curvature);
  }
  return best;
}

/// Takes the best of all sums of multiples of the guesses for x, and off the residual b − A x; by
/// how much ½xᵀAx − bᵀx is then lower than at x = 0.
double take_best_guess(const SparseSymmetric& A, std::span<const Eigen::VectorXd> guesses,
                       Eigen::VectorXd& x, ConjugateGradientRoom& room) {
  std::vector<const Eigen::VectorXd*> p;
  room.images.resize(std::max(room.images.size(), guesses.size()));
  for (const Eigen::VectorXd& guess : guesses) {
    if (guess.size() != x.size()) continue;
    multiply(A, guess, room.images[p.size()]);
    p.push_back(&guess);
  }
  if (p.empty()) return 0;
  const BestGuess best = best_guess(products_of({p, room.images, room.residual}));
  in_ranges(x.size(), kEntriesTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double multiple = best.multiples[static_cast<Eigen::Index>(i)];
      x.segment(begin, end - begin) += multiple * p[i]->segment(begin, end - begin);
      room.residual.segment(begin, end - begin) -=
          multiple * room.images[i].segment(begin, end - begin);
    }
  });
  return best.decrease;
}

}  // namespace

ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              const Preconditioner& precondition,
                                              const ConjugateGradientSettings& settings) {
  ConjugateGradientRoom own;
  ConjugateGradientRoom& room = settings.room ? *settings.room : own;
  Eigen::VectorXd &residual = room.residual, &direction = room.direction;
  ConjugateGradientSolution solution{zeros<Eigen::VectorXd>(b.size())};
  copy(b, residual);
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
      settings.least_gain >= kLeastGainOfSinglePrecision || factor.precision() != Precision::full;
  const Preconditioner precondition = [&](const Eigen::VectorXd& r) {
    return is_single ? factor.precondition(r) : factor.solve(r);
  };
  ConjugateGradientSettings stoppable = settings;
  stoppable.token = factor.token();
  return conjugate_gradients(A, b, precondition, stoppable);
}

}  // namespace foldless
