// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/single_precision_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/elimination_tree.h"
#include "core/linear/multifrontal.h"
#include "core/linear/ordering.h"
#include "core/linear/sweep.h"
#include "core/linear/symbolic_analysis.h"
#include "core/linear/triangular_solve.h"
#include "core/threads/team.h"
#include "tests/support/random_symmetric.h"

namespace foldless {
namespace {

constexpr unsigned kSingleSeeds = 60;

TEST(SinglePrecisionSolve, IsThatOfDoublePrecisionButForRounding) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor does not";
  for (unsigned seed = 1; seed <= kSingleSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = test::dominated(test::random_symmetric(seed), seed);
    const SymbolicFactor factor =
        symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
    std::vector<double> values(factor.values);
    Buffer<std::byte> updates;
    ASSERT_EQ(factorize(factor, m, 0, values.data(), updates), m.size());
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(factor.solve_size(), -1, 2), work;
    Eigen::VectorXf single_x = x.cast<float>();
    triangular_solve(factor, values.data(), x, work);
    // What is behind the values must not matter where it is a number, nor the work space at all.
    constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> single(factor.values + kSingleOverrun, 12345.0F);
    std::vector<float> single_work(sweep_work_size(factor, kSingleOverrun), kNotANumber);
    to_single_precision(factor, values.data(), single.data());
    triangular_solve_single(factor, single.data(), single_x.data(), single_work.data());
    x.conservativeResize(m.size());
    single_x.conservativeResize(m.size());
    EXPECT_LT((single_x.cast<double>() - x).norm(), 1e-5 * x.norm());
  }
}

TEST(SinglePrecisionSolve, ALargePanelIsRoundedByAllThreads) {
  const Supernode s{.first = 0, .columns = 402, .below = 200};
  const Eigen::MatrixXd panel = Eigen::MatrixXd::Random(s.rows(), s.columns);
  Eigen::MatrixXf expected = panel.cast<float>(), alone = expected, shared = expected;
  for (int j = 0; j < s.columns; ++j) expected.col(j).head(j).setZero();
  shared.setOnes();
  to_single_precision(s, panel.data(), alone.data());
  Team team(3);
  const WithTeam with(&team);
  to_single_precision(s, panel.data(), shared.data());
  EXPECT_EQ(alone, expected);
  EXPECT_EQ(shared, expected);
}

TEST(SinglePrecisionSolve, PreconditionsLargeAndSmallRightHandSidesAlike) {
  const SparseSymmetric m = test::dominated(test::random_symmetric(7), 7);
  Cholesky cholesky;
  cholesky.analyze(m);
  ASSERT_TRUE(cholesky.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  const Eigen::VectorXd x = cholesky.solve(b);
  for (const double scale : {1.0, 1e-200, 1e200}) {
    SCOPED_TRACE(scale);
    EXPECT_LT((cholesky.precondition(scale * b) / scale - x).norm(), 1e-5 * x.norm());
  }
  EXPECT_TRUE(cholesky.precondition(Eigen::VectorXd::Zero(m.size())).isZero(0));
}

TEST(SinglePrecisionSolve, PreconditionsWithTheLatestFactor) {
  const SparseSymmetric m = test::dominated(test::random_symmetric(7), 7);
  Cholesky cholesky;
  cholesky.analyze(m);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  for (const double shift : {0.0, 100.0}) {
    ASSERT_TRUE(cholesky.factorize(m, shift));
    const Eigen::VectorXd x = cholesky.solve(b);
    EXPECT_LT((cholesky.precondition(b) - x).norm(), 1e-5 * x.norm());
    Cholesky copy = cholesky;
    EXPECT_EQ(copy.precondition(b), cholesky.precondition(b));
    ASSERT_TRUE(copy.factorize(m, 7, Precision::single));
    EXPECT_LT((cholesky.precondition(b) - x).norm(), 1e-5 * x.norm()) << "it was its own";
    EXPECT_GT((copy.precondition(b) - x).norm(), 1e-2 * x.norm());
    ASSERT_TRUE(copy.factorize(m, 7, Precision::rounded));
    EXPECT_LT((cholesky.precondition(b) - x).norm(), 1e-5 * x.norm()) << "it was its own";
    ASSERT_TRUE(copy.factorize(m, shift, Precision::rounded));
    EXPECT_EQ(copy.precondition(b), cholesky.precondition(b)) << "both are rounded from doubles";
    ASSERT_TRUE(copy.factorize(m, shift, Precision::single));
    EXPECT_LT((copy.precondition(b) - x).norm(), 1e-4 * x.norm());
    const Cholesky second = copy;
    EXPECT_EQ(Cholesky(second).precondition(b), copy.precondition(b));
  }
}

TEST(SinglePrecisionSolve, AFactorInSinglePrecisionSaysWhatIsTooLargeOrSmallForIt) {
  if (!solves_in_single_precision()) GTEST_SKIP() << "this processor does not";
  for (const double scale : {1e60, 1e-60}) {
    SCOPED_TRACE(scale);
    SparseSymmetric m = test::dominated(test::random_symmetric(7), 7);
    for (double& value : m.value) value *= scale;
    Cholesky cholesky;
    cholesky.analyze(m);
    EXPECT_FALSE(cholesky.factorize(m, 0, Precision::single));
    EXPECT_FALSE(cholesky.has_factor());
    EXPECT_TRUE(cholesky.factorize(m));
  }
}

}  // namespace
}  // namespace foldless
