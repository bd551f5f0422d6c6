// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multifrontal.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <random>
#include <thread>

#include "core/linear/cholesky.h"
#include "core/linear/ordering.h"
#include "tests/support/dense_matrix.h"
#include "tests/support/random_symmetric.h"

namespace foldless {
namespace {

using test::diagonal;
using test::dominated;
using test::random_symmetric;

constexpr unsigned kSeeds = 60;

Eigen::SparseMatrix<double> lower(const SparseSymmetric& m) {
  return Eigen::Map<const Eigen::SparseMatrix<double>>(
      m.size(), m.size(), static_cast<Eigen::Index>(m.row.size()), m.column_start.data(),
      m.row.data(), m.value.data());
}

/// The first column, in the order of elimination, at which the scalar algorithm finds a pivot that
/// is not positive.
int first_failure(const SparseSymmetric& m, const std::vector<int>& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic> permutation(m.size());
  for (int k = 0; k < m.size(); ++k)
    permutation.indices()[2 * order[static_cast<std::size_t>(k / 2)] + k % 2] = k;
  Eigen::MatrixXd a = permutation * test::dense(m) * permutation.transpose();
  for (int j = 0; j < m.size(); ++j) {
    if (!(a(j, j) > 0)) return j;
    const Eigen::VectorXd column = a.col(j).tail(m.size() - j - 1);
    a.bottomRightCorner(column.size(), column.size()) -= column * column.transpose() / a(j, j);
  }
  return m.size();
}

TEST(Multifrontal, SolvesAsEigenDoes) {
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = dominated(random_symmetric(seed), seed);
    Cholesky cholesky;
    cholesky.analyze(m);
    ASSERT_TRUE(cholesky.factorize(m));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> eigen(lower(m));
    ASSERT_EQ(eigen.info(), Eigen::Success);
    const Eigen::VectorXd expected = eigen.solve(b);
    EXPECT_LT((cholesky.solve(b) - expected).norm(), 1e-11 * expected.norm());
  }
}

TEST(Multifrontal, NoticesAnIndefiniteMatrixAtTheColumnWhereItShows) {
  int inside = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    SparseSymmetric m = dominated(random_symmetric(seed), seed);
    std::mt19937 random(seed);
    diagonal(m, std::uniform_int_distribution(0, m.size() - 1)(random)) *= -0.5;
    const SymbolicFactor factor = symbolic_factor(m, fill_reducing_ordering(m));
    Buffer<double> values;
    values.reserve(factor.values);
    UpdateStacks stacks;
    const int found = factorize(factor, m, 0, values.data(), stacks);
    EXPECT_EQ(found, first_failure(m, factor.order));
    inside += found > 0 && found + 1 < m.size();
  }
  EXPECT_GT(inside, static_cast<int>(kSeeds) / 2);
}

TEST(Multifrontal, PanelsHoldAllRowsOfTheFactorAndFew) {
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = random_symmetric(seed);
    const SymbolicFactor factor = symbolic_factor(m, fill_reducing_ordering(m));
    int column = 0;
    for (const Supernode& s : factor.supernodes) {
      EXPECT_EQ(s.first, column);
      column += s.columns;
      const auto rows = factor.rows_of(s);
      EXPECT_TRUE(std::ranges::is_sorted(rows, std::less_equal<>()) || rows.size() < 2);
      EXPECT_TRUE(rows.empty() || rows.front() >= column / 2);
      EXPECT_EQ(rows.empty(), s.parent < 0);
    }
    EXPECT_EQ(column, m.size());
  }
}

TEST(Multifrontal, TwoAtOnceGiveTheSameBitsAsOneAfterTheOther) {
  const auto solution = [](unsigned seed) {
    const SparseSymmetric m = dominated(random_symmetric(seed), seed);
    Cholesky cholesky;
    cholesky.analyze(m);
    EXPECT_TRUE(cholesky.factorize(m));
    return cholesky.solve(Eigen::VectorXd::Ones(m.size()));
  };
  std::vector<Eigen::VectorXd> alone, at_once[2];
  const auto solve_all = [&](std::vector<Eigen::VectorXd>& to) {
    for (unsigned seed = 1; seed <= kSeeds; ++seed) to.push_back(solution(seed));
  };
  solve_all(alone);
  {
    std::jthread first([&] { solve_all(at_once[0]); }), second([&] { solve_all(at_once[1]); });
  }
  EXPECT_EQ(at_once[0], alone);
  EXPECT_EQ(at_once[1], alone);
}

TEST(Multifrontal, AFactorThatWasCopiedStaysWhenTheCopyFactorizes) {
  const SparseSymmetric m = dominated(random_symmetric(7), 7);
  SparseSymmetric indefinite = m;
  diagonal(indefinite, 0) = -1;
  Cholesky cholesky;
  cholesky.analyze(m);
  ASSERT_TRUE(cholesky.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(m.size()), before = cholesky.solve(b);
  Cholesky copy = cholesky;
  EXPECT_FALSE(copy.factorize(indefinite));
  EXPECT_FALSE(copy.has_factor());
  ASSERT_TRUE(cholesky.has_factor());
  EXPECT_EQ(cholesky.solve(b), before);
}

}  // namespace
}  // namespace foldless
