// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/conjugate_gradients.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

constexpr double kLeastGain = 1e-14;

/// Random blocks on the edges of a random graph, dominated by the diagonal.
SparseSymmetric random_matrix(int nodes, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> node(0, nodes - 1);
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i + 1 < nodes; ++i) edges.emplace_back(i, i + 1);
  for (int i = 0; i < 2 * nodes; ++i) {
    const int a = node(random), b = node(random);
    if (a != b) edges.emplace_back(a, b);
  }
  SparseSymmetric m = sparse_symmetric(nodes, edges);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (double& value : m.value) value = unit(random);
  for (int i = 0; i < m.size(); ++i) test::diagonal(m, i) += 30;
  return m;
}

/// Adds to the diagonal, here more and there less.
SparseSymmetric changed(SparseSymmetric m, double by) {
  for (int i = 0; i < m.size(); ++i) test::diagonal(m, i) += by * (1 + i % 5);
  return m;
}

Cholesky factor_of(const SparseSymmetric& m) {
  Cholesky factor;
  factor.analyze(m);
  EXPECT_TRUE(factor.factorize(m));
  return factor;
}

TEST(Multiply, IsTheProductOfTheWholeMatrix) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    const SparseSymmetric m = random_matrix(20, seed);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
    Eigen::VectorXd y;
    multiply(m, x, y);
    EXPECT_LT((y - test::dense(m) * x).norm(), 1e-12);
  }
}

TEST(ConjugateGradients, BeginAtTheBestSumOfMultiplesOfGuesses) {
  const SparseSymmetric m = random_matrix(60, 5);
  Cholesky factor = factor_of(changed(m, 10));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Eigen::VectorXd exact = test::dense(m).ldlt().solve(b);
  const Eigen::VectorXd other = Eigen::VectorXd::LinSpaced(m.size(), 1, -1);
  const auto solve = [&](const std::vector<Eigen::VectorXd>& guesses, double least_gain) {
    return conjugate_gradients(m, b, factor, {least_gain, 50, guesses});
  };
  const ConjugateGradientSolution cold = solve({}, kLeastGain);
  EXPECT_LT((cold.x - exact).norm(), 1e-6 * exact.norm());
  // Where the solution is such a sum there is nothing to do.
  const std::vector<std::vector<Eigen::VectorXd>> sums{
      {7 * exact}, {-exact}, {exact + other, other}, {other, exact - 3 * other}};
  for (const std::vector<Eigen::VectorXd>& guesses : sums) {
    const ConjugateGradientSolution warm = solve(guesses, kLeastGain);
    EXPECT_LT(warm.iterations, 2);
    EXPECT_LT((warm.x - exact).norm(), 1e-12 * exact.norm());
  }
  const Eigen::VectorXd near = exact + 0.01 * other;
  EXPECT_LT(solve({near}, 1e-4).iterations, solve({}, 1e-4).iterations);
  EXPECT_LT((solve({near}, kLeastGain).x - exact).norm(), 1e-6 * exact.norm());
}

TEST(ConjugateGradients, PassOverGuessesThatAddNothing) {
  const SparseSymmetric m = random_matrix(60, 5);
  Cholesky factor = factor_of(changed(m, 10));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Eigen::VectorXd guess = Eigen::VectorXd::LinSpaced(m.size(), 1, -1);
  const auto solve = [&](const std::vector<Eigen::VectorXd>& guesses) {
    return conjugate_gradients(m, b, factor, {kLeastGain, 50, guesses}).x;
  };
  const Eigen::VectorXd cold = solve({}), one = solve({guess});
  EXPECT_EQ(solve({guess.head(4)}), cold);
  EXPECT_EQ(solve({0 * guess}), cold);
  EXPECT_EQ(solve({guess, guess.head(4)}), one);
  EXPECT_EQ(solve({guess, -2 * guess}), one);
}

TEST(ConjugateGradients, MakeUpForAFactorInSinglePrecision) {
  const SparseSymmetric m = random_matrix(60, 5);
  Cholesky factor;
  factor.analyze(m);
  ASSERT_TRUE(factor.factorize(m, 0, Precision::single));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Eigen::VectorXd exact = test::dense(m).ldlt().solve(b);
  const ConjugateGradientSolution solution = conjugate_gradients(m, b, factor, {1e-26, 8});
  EXPECT_EQ(solution.end, ConjugateGradientEnd::converged);
  EXPECT_LT((solution.x - exact).norm(), 1e-12 * exact.norm());
}

TEST(ConjugateGradients, GiveUpWhereTheFactorGivesNoNumbers) {
  SparseSymmetric tiny = random_matrix(20, 3);
  for (double& value : tiny.value) value *= 1e-42;
  Cholesky factor;
  factor.analyze(tiny);
  ASSERT_TRUE(factor.factorize(tiny, 0, Precision::single));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(tiny.size(), -1, 2);
  if (factor.precondition(b).allFinite()) GTEST_SKIP() << "this processor solves in doubles alone";
  const ConjugateGradientSolution solution = conjugate_gradients(tiny, b, factor, {1e-2, 8});
  EXPECT_EQ(solution.end, ConjugateGradientEnd::slow);
}

TEST(ConjugateGradients, StopWhenTheFactorIsToObey) {
  const SparseSymmetric m = random_matrix(20, 1);
  Cholesky factor = factor_of(changed(m, 20));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const ConjugateGradientSettings settings{.least_gain = 1e-12, .most_iterations = 100};
  ASSERT_GT(conjugate_gradients(m, b, factor, settings).iterations, 1)
      << "the claim would be empty";
  std::stop_source stop;
  factor.obey(stop.get_token());
  EXPECT_EQ(conjugate_gradients(m, b, factor, settings).end, ConjugateGradientEnd::converged);
  stop.request_stop();
  const ConjugateGradientSolution stopped = conjugate_gradients(m, b, factor, settings);
  EXPECT_EQ(stopped.end, ConjugateGradientEnd::stopped);
  EXPECT_EQ(stopped.iterations, 1);
}

TEST(ConjugateGradients, GiveUpWhereALaterIterationGainsTooMuch) {
  const SparseSymmetric m = random_matrix(60, 5);
  Cholesky factor = factor_of(changed(m, 200));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const auto end = [&](double largest_gain) {
    const ConjugateGradientSettings settings{
        .least_gain = 1e-3, .most_iterations = 50, .largest_gain = largest_gain};
    return conjugate_gradients(m, b, factor, settings);
  };
  EXPECT_EQ(end(1).end, ConjugateGradientEnd::converged);
  EXPECT_EQ(end(1e-3).end, ConjugateGradientEnd::slow);
  EXPECT_EQ(end(1e-3).iterations, 2) << "the first gains all that there is yet";
}

TEST(ConjugateGradients, SayThatAPreconditionerIsNotPositiveDefinite) {
  const SparseSymmetric m = random_matrix(20, 5);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Preconditioner negative = [](const Eigen::VectorXd& r) { return -r; };
  const ConjugateGradientSettings settings{.least_gain = 1e-2, .most_iterations = 8};
  EXPECT_EQ(conjugate_gradients(m, b, negative, settings).end, ConjugateGradientEnd::indefinite);
  EXPECT_EQ(conjugate_gradients(m, 0 * b, negative, settings).end, ConjugateGradientEnd::converged)
      << "there is nothing to solve";
}

TEST(ConjugateGradients, TakeAnyPreconditionerAndStopAsTheSettingsSay) {
  const SparseSymmetric m = random_matrix(60, 5);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Preconditioner a_thirtieth = [](const Eigen::VectorXd& r) { return r / 30; };
  std::stop_source stop;
  ConjugateGradientSettings settings{.least_gain = kLeastGain, .most_iterations = 100};
  settings.token = stop.get_token();
  const ConjugateGradientSolution found = conjugate_gradients(m, b, a_thirtieth, settings);
  EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
  EXPECT_LT((test::dense(m) * found.x - b).norm(), 1e-6 * b.norm());
  stop.request_stop();
  EXPECT_EQ(conjugate_gradients(m, b, a_thirtieth, settings).end, ConjugateGradientEnd::stopped);
}

// Both sizes: a few supernodes and many.
class ConjugateGradientsTest : public testing::TestWithParam<int> {};

TEST_P(ConjugateGradientsTest, SolveWithTheFactorOfANearMatrix) {
  for (const unsigned seed : {4U, 5U}) {
    SCOPED_TRACE(seed);
    const SparseSymmetric m = random_matrix(GetParam(), seed);
    Cholesky factor = factor_of(changed(m, 5));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
    const ConjugateGradientSolution found = conjugate_gradients(m, b, factor, {kLeastGain, 50});
    EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
    EXPECT_GT(found.iterations, 1);
    Eigen::VectorXd image;
    multiply(m, found.x, image);
    EXPECT_LT((image - b).norm(), 1e-6 * b.norm());
  }
}

TEST_P(ConjugateGradientsTest, NeedOneIterationWithTheMatrixsOwnFactor) {
  const SparseSymmetric m = random_matrix(GetParam(), 6);
  Cholesky factor = factor_of(m);
  const ConjugateGradientSolution found =
      conjugate_gradients(m, Eigen::VectorXd::Ones(m.size()), factor, {kLeastGain, 50});
  EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
  EXPECT_EQ(found.iterations, 1);
}

TEST_P(ConjugateGradientsTest, GiveUpAfterAsManyIterationsAsTheyMayTake) {
  const SparseSymmetric m = random_matrix(GetParam(), 7);
  Cholesky factor = factor_of(changed(m, 50));
  const ConjugateGradientSolution found =
      conjugate_gradients(m, Eigen::VectorXd::Ones(m.size()), factor, {kLeastGain, 2});
  EXPECT_EQ(found.end, ConjugateGradientEnd::slow);
  EXPECT_EQ(found.iterations, 2);
}

TEST_P(ConjugateGradientsTest, NoticeAnIndefiniteMatrix) {
  const SparseSymmetric m = random_matrix(GetParam(), 8);
  Cholesky factor = factor_of(m);
  const ConjugateGradientSolution found = conjugate_gradients(
      changed(m, -30), Eigen::VectorXd::LinSpaced(m.size(), -1, 2), factor, {kLeastGain, 50});
  EXPECT_EQ(found.end, ConjugateGradientEnd::indefinite);
}

TEST_P(ConjugateGradientsTest, OfNothingAreNothing) {
  const SparseSymmetric m = random_matrix(GetParam(), 9);
  Cholesky factor = factor_of(m);
  const ConjugateGradientSolution found =
      conjugate_gradients(m, Eigen::VectorXd::Zero(m.size()), factor, {kLeastGain, 50});
  EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
  EXPECT_TRUE(found.x.isZero(0));
}

INSTANTIATE_TEST_SUITE_P(Sizes, ConjugateGradientsTest, testing::Values(20, 700));

}  // namespace
}  // namespace foldless
