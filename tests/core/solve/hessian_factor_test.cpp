// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/hessian_factor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/energy/densities.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/core/linear/random_values.h"
#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

constexpr int kSize = 16;  ///< of the fine grid

HessianKind kind() { return {.density = find_density("arap"), .beta = 2, .held = true}; }

Hessian hessian(int n = kSize) { return {test::elastic_grid(n), kind()}; }

/// With a factor of its own, as the system of the coarse mesh has one.
HessianFactor factorized(const Hessian& of) {
  HessianFactor factor;
  factor.analyze(of.matrix);
  EXPECT_TRUE(factor.factorize(of, 0, Precision::full));
  return factor;
}

/// A system of the fine grid, over one coarse grid whose matrix is made softer by `softness` at
/// every other node, of all unknowns by themselves.
HessianFactor over_coarse(double softness = 0) {
  Hessian coarse = hessian(kSize / 2);
  if (softness != 0)
    for (int i = 0; i < coarse.matrix.nodes; i += 2)
      add_block(coarse.matrix, i, i, softness * Eigen::Matrix2d::Identity());
  HessianFactor fine;
  fine.set_coarse(
      factorized(coarse).as_coarse(test::to_twice_as_fine(kSize / 2), std::move(coarse)));
  return fine;
}

Eigen::VectorXd right_hand_side() { return test::random_values(hessian().matrix.size(), 5); }

std::optional<ConjugateGradientSolution> solution(HessianFactor& factor, const Hessian& of) {
  return factor.solve_later(of, right_hand_side(), 1e-2, {});
}

TEST(HessianFactor, GuessesAreForTheFactorOfAnEarlierHessian) {
  const Hessian own = hessian();
  const std::vector<Eigen::VectorXd> guesses{test::random_values(own.matrix.size(), 6)};
  for (const Precision precision : {Precision::full, Precision::single}) {
    HessianFactor factor;
    factor.analyze(own.matrix);
    ASSERT_TRUE(factor.factorize(own, 0, precision));
    const auto solve = [&](std::span<const Eigen::VectorXd> from) {
      return factor.solve_later(own, right_hand_side(), 1e-2, from);
    };
    EXPECT_EQ(solve(guesses)->x, solve({})->x) << "from the Hessian's own factor";
    EXPECT_EQ(solve(guesses)->iterations, 1) << "which shows that nothing is left";
    factor.outdate();
    EXPECT_NE(solve(guesses)->x, solve({})->x);
  }
}

constexpr int kLargeSize = 45;  ///< of a grid of 4,232 unknowns

/// The Hessian where `count` nodes, from 100 on, have `times` the stiffness, the trace of their
/// block.
Hessian changed_hessian(int count, double times, int n = kLargeSize) {
  Hessian changed = hessian(n);
  SparseSymmetric& A = changed.matrix;
  for (int node = 100; node < 100 + count; ++node) {
    const double trace = test::diagonal(A, 2 * node) + test::diagonal(A, 2 * node + 1);
    add_block(A, node, node, (times - 1) * trace / 2 * Eigen::Matrix2d::Identity());
  }
  return changed;
}

std::optional<ConjugateGradientSolution> solution_from_earlier(HessianFactor& factor,
                                                               const Hessian& of) {
  factor.outdate();
  return factor.solve_later(of, test::random_values(of.matrix.size(), 5), 1e-2, {});
}

/// Of hessian(n), of as many nodes.
Cholesky earlier_factor(const Hessian& of) {
  const Hessian earlier = hessian(static_cast<int>(std::lround(std::sqrt(of.matrix.nodes))) - 1);
  Cholesky factor;
  factor.analyze(earlier.matrix);
  EXPECT_TRUE(factor.factorize(earlier.matrix));
  return factor;
}

/// Of some nodes, in the order in which that factor eliminates them.
LocalSolve local_solve(const Hessian& of, std::vector<int> nodes) {
  earlier_factor(of).sort_by_elimination(nodes);
  return {of.matrix, nodes};
}

/// By that factor, with a local solve where there is one.
ConjugateGradientSolution plain_solution(const Hessian& of, LocalSolve* local = nullptr) {
  Cholesky factor = earlier_factor(of);
  const ConjugateGradientSettings settings{
      .least_gain = 1e-2, .most_iterations = 100, .local = local};
  return conjugate_gradients(of.matrix, test::random_values(of.matrix.size(), 5), factor, settings);
}

/// `count` nodes from 100 on, those beside them and those beside these.
std::vector<int> with_two_rings(int count, const SparseSymmetric& A) {
  std::vector<int> nodes(static_cast<std::size_t>(count));
  std::iota(nodes.begin(), nodes.end(), 100);
  return with_neighbours(A, with_neighbours(A, nodes));
}

TEST(HessianFactor, SolvesForAFewNodesThatBecameStifferByThemselves) {
  HessianFactor factor = factorized(hessian(kLargeSize));
  const Hessian stiffer = changed_hessian(10, 1000);
  const auto found = solution_from_earlier(factor, stiffer);
  ASSERT_TRUE(found);
  EXPECT_LT(found->iterations, plain_solution(stiffer).iterations);

  LocalSolve local = local_solve(stiffer, with_two_rings(10, stiffer.matrix));
  EXPECT_EQ(found->x, plain_solution(stiffer, &local).x);
}

TEST(HessianFactor, SolvesForNodesByThemselvesWhereTheyAreFewOfMany) {
  const auto is_plain = [](const Hessian& changed, int n) {
    HessianFactor factor = factorized(hessian(n));
    return solution_from_earlier(factor, changed)->x == plain_solution(changed).x;
  };
  constexpr int kLarger = 79;  // 6,400 nodes, of which a fiftieth is more than a hundred
  for (const auto& [n, all] : {std::pair(kLargeSize, 100U), std::pair(kLarger, 128U)}) {
    SCOPED_TRACE(n);
    int most = 1;
    while (with_two_rings(most + 1, hessian(n).matrix).size() <= all) ++most;
    EXPECT_FALSE(is_plain(changed_hessian(most, 1.5, n), n));
    EXPECT_TRUE(is_plain(changed_hessian(most + 1, 1.5, n), n));
  }
  EXPECT_TRUE(is_plain(changed_hessian(3, 1.5, kSize), kSize));
}

TEST(HessianFactor, OfManyNodesSolvesForThoseThatChangedMostByThemselves) {
  HessianFactor factor = factorized(hessian(kLargeSize));
  Hessian stiffer = changed_hessian(100, 1.3);
  const Hessian most = changed_hessian(5, 1.8);
  for (std::size_t k = 0; k < most.matrix.value.size(); ++k)
    stiffer.matrix.value[k] = std::max(stiffer.matrix.value[k], most.matrix.value[k]);
  LocalSolve local = local_solve(stiffer, with_two_rings(5, stiffer.matrix));
  EXPECT_EQ(solution_from_earlier(factor, stiffer)->x, plain_solution(stiffer, &local).x);
}

TEST(HessianFactor, SolvesForNodesByThemselvesWhoseStiffnessChangedEnough) {
  for (const auto& [times, is_plain] : {std::pair(1.04, true), std::pair(1.06, false),
                                        std::pair(1 / 1.04, true), std::pair(1 / 1.06, false)}) {
    HessianFactor factor = factorized(hessian(kLargeSize));
    const Hessian changed = changed_hessian(3, times);
    EXPECT_EQ(solution_from_earlier(factor, changed)->x == plain_solution(changed).x, is_plain);
  }
}

/// The Hessian where so many nodes here and there are a little stiffer: what costs iterations, and
/// is too little for a local solve.
Hessian propped_hessian(int count) {
  Hessian propped = hessian(kLargeSize);
  SparseSymmetric& A = propped.matrix;
  for (int k = 0; k < count; ++k) {
    const int node = (2 * k + 1) * A.nodes / (2 * count);
    const double trace = test::diagonal(A, 2 * node) + test::diagonal(A, 2 * node + 1);
    add_block(A, node, node, 0.045 * trace * Eigen::Matrix2d::Identity());
  }
  return propped;
}

TEST(HessianFactor, ServesAfterManyIterationsWhereNodesAreSolvedForByThemselves) {
  const auto solve = [](HessianFactor& factor, int props, bool is_stiffer_somewhere) {
    Hessian far = propped_hessian(props);
    if (is_stiffer_somewhere) add_block(far.matrix, 100, 100, 50 * Eigen::Matrix2d::Identity());
    factor.outdate();
    return factor.solve_later(far, test::random_values(far.matrix.size(), 5), 1e-4, {});
  };
  for (const bool is_stiffer_somewhere : {false, true}) {
    SCOPED_TRACE(is_stiffer_somewhere);
    HessianFactor factor = factorized(hessian(kLargeSize));
    const auto found = solve(factor, 60, is_stiffer_somewhere);
    ASSERT_TRUE(found);
    EXPECT_GE(found->iterations, 5) << "the claim would be empty";
    EXPECT_EQ(factor.is_near(kind()), is_stiffer_somewhere);
  }
  HessianFactor factor = factorized(hessian(kLargeSize));
  EXPECT_FALSE(solve(factor, 320, true)) << "eight iterations are not enough";
  EXPECT_FALSE(factor.is_near(kind()));
}

TEST(HessianFactor, SeesThatAFewNodesMakeAHessianIndefinite) {
  HessianFactor factor = factorized(hessian(kLargeSize));
  const Hessian indefinite = changed_hessian(3, -0.5);
  // A node far from them moves alone and is guessed, so that iterations do not meet them.
  const Eigen::Index size = indefinite.matrix.size();
  const std::vector<Eigen::VectorXd> guesses{Eigen::VectorXd::Unit(size, size - 1)};
  Eigen::VectorXd b(size);
  multiply(indefinite.matrix, guesses[0], b);
  factor.outdate();
  const auto found = factor.solve_later(indefinite, b, 1e-2, guesses);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->end, ConjugateGradientEnd::indefinite);
  EXPECT_TRUE(solution_from_earlier(factor, hessian(kLargeSize))) << "the factor is kept";
}

TEST(HessianFactor, SolvesFromACoarseMeshWithoutAFactor) {
  HessianFactor factor = over_coarse(), none;
  const Hessian fine = hessian();
  const auto found = solution(factor, fine);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->end, ConjugateGradientEnd::converged);
  EXPECT_FALSE(solution(none, fine));
  // The model's decrease is nearly that of Newton's step.
  const Eigen::VectorXd exact = factorized(fine).solve(right_hand_side());
  Eigen::VectorXd image;
  multiply(fine.matrix, found->x, image);
  const double decrease = right_hand_side().dot(found->x) - 0.5 * found->x.dot(image);
  EXPECT_GT(decrease, 0.97 * 0.5 * right_hand_side().dot(exact));
}

TEST(HessianFactor, TheCoarseMeshServesNoHessianOfAnotherKind) {
  HessianFactor factor = over_coarse();
  Hessian other = hessian();
  other.kind.beta = 3;
  EXPECT_FALSE(solution(factor, other));
  EXPECT_TRUE(solution(factor, hessian())) << "it is kept";
}

TEST(HessianFactor, SeesThatAHessianIsIndefinite) {
  HessianFactor factor = over_coarse();
  Hessian indefinite = hessian();
  add_block(indefinite.matrix, 40, 40, -100 * Eigen::Matrix2d::Identity());
  const auto found = solution(factor, indefinite);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->end, ConjugateGradientEnd::indefinite);
  EXPECT_TRUE(solution(factor, hessian())) << "the coarse mesh is kept";
}

TEST(HessianFactor, ACoarseMeshThatServedBadlyIsForgotten) {
  HessianFactor factor = over_coarse(1e5);
  const Hessian fine = hessian();
  EXPECT_FALSE(solution(factor, fine));
  EXPECT_FALSE(factor.as_coarse(test::to_twice_as_fine(kSize), fine)) << "there is nothing";
  factor.analyze(fine.matrix);
  ASSERT_TRUE(factor.factorize(fine, 0, Precision::full));
  EXPECT_TRUE(factor.as_coarse(test::to_twice_as_fine(kSize), fine));
}

TEST(HessianFactor, AFinerMeshIsSolvedOverTwoCoarseOnes) {
  const HessianFactor middle = over_coarse();
  HessianFactor finest;
  finest.set_coarse(middle.as_coarse(test::to_twice_as_fine(kSize), hessian()));
  const Hessian fine = hessian(2 * kSize);
  EXPECT_TRUE(finest.solve_later(fine, test::random_values(fine.matrix.size(), 5), 1e-2, {}));
  Hessian indefinite = hessian();
  add_block(indefinite.matrix, 40, 40, -100 * Eigen::Matrix2d::Identity());
  EXPECT_FALSE(middle.as_coarse(test::to_twice_as_fine(kSize), indefinite));
}

TEST(HessianFactor, ForgetsTheCoarseMeshWhenItHasAFactor) {
  HessianFactor factor = over_coarse();
  const Hessian fine = hessian();
  factor.analyze(fine.matrix);
  ASSERT_TRUE(factor.factorize(fine, 0, Precision::full));
  factor.set_far();
  EXPECT_FALSE(solution(factor, fine));
}

TEST(HessianFactor, OfAnotherMeshServesNeitherThatNorAFinerOne) {
  HessianFactor factor = over_coarse(), own = factorized(hessian());
  factor.forget_mesh();
  own.forget_mesh();
  EXPECT_FALSE(solution(factor, hessian()));
  EXPECT_FALSE(solution(own, hessian()));
  EXPECT_FALSE(own.as_coarse(test::to_twice_as_fine(kSize), hessian()));
}

TEST(HessianFactor, StopsAndKeepsTheCoarseMesh) {
  HessianFactor factor = over_coarse();
  std::stop_source stop;
  stop.request_stop();
  factor.obey(stop.get_token());
  EXPECT_FALSE(solution(factor, hessian()));
  factor.obey({});
  EXPECT_TRUE(solution(factor, hessian()));
}

}  // namespace
}  // namespace foldless
