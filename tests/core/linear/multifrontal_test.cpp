// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multifrontal.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/elimination_tree.h"
#include "core/linear/ordering.h"
#include "core/linear/single_precision_solve.h"
#include "core/linear/sweep.h"
#include "core/linear/symbolic_analysis.h"
#include "core/linear/triangular_solve.h"
#include "core/threads/team.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/support/dense_matrix.h"
#include "tests/support/random_symmetric.h"
#include "tests/support/square_pattern.h"

namespace foldless {
namespace {

using test::diagonal;
using test::dominated;
using test::random_symmetric;

constexpr unsigned kSeeds = 60;

Eigen::SparseMatrix<double> lower(const SparseSymmetric& m) {
  std::vector<Eigen::Triplet<double>> entries;
  test::for_each_entry(
      m, [&](int row, int column, double value) { entries.emplace_back(row, column, value); });
  Eigen::SparseMatrix<double> lower(m.size(), m.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
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
    for (int i = j + 1; i < m.size(); ++i) {
      const double part = a(i, j) / a(j, j);
      if (part != 0) a.col(i).tail(m.size() - i) -= part * a.col(j).tail(m.size() - i);
    }
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
    const SymbolicFactor factor = symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)));
    Buffer<double> values;
    values.reserve(factor.values);
    Buffer<std::byte> updates;
    const int found = factorize(factor, m, 0, values.data(), updates);
    EXPECT_EQ(found, first_failure(m, factor.order));
    inside += found > 0 && found + 1 < m.size();
  }
  EXPECT_GT(inside, static_cast<int>(kSeeds) / 2);
}

TEST(Multifrontal, PanelsHoldAllRowsOfTheFactorAndFew) {
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = random_symmetric(seed);
    const SymbolicFactor factor = symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)));
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

/// What a solve with these values makes of a vector of ones, in double and, where the processor has
/// it, in single precision.
std::vector<double> solutions(const SymbolicFactor& factor, const double* values) {
  Eigen::VectorXd x = Eigen::VectorXd::Ones(factor.solve_size()), work;
  triangular_solve(factor, values, x, work);
  std::vector<double> all(x.data(), x.data() + factor.size());
  if (!solves_in_single_precision()) return all;
  std::vector<float> single(factor.values + kSingleOverrun);
  to_single_precision(factor, values, single.data());
  std::vector<float> y(static_cast<std::size_t>(factor.solve_size()), 1);
  std::vector<float> single_work(sweep_work_size(factor, kSingleOverrun));
  triangular_solve_single(factor, single.data(), y.data(), single_work.data());
  all.insert(all.end(), y.begin(), y.begin() + factor.size());
  return all;
}

TEST(Multifrontal, RoundedPanelsAreThoseOfTheFactorInDoubles) {
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = dominated(random_symmetric(seed), seed);
    const SymbolicFactor factor =
        symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
    std::vector<double> values(factor.values);
    std::vector<float> rounded(factor.values), one_thread(factor.values), three(factor.values);
    Buffer<std::byte> room;
    ASSERT_EQ(factorize(factor, m, 0.5, values.data(), room), m.size());
    ASSERT_EQ(factorize(factor, m, 0.5, one_thread.data(), room), m.size());
    to_single_precision(factor, values.data(), rounded.data());
    EXPECT_EQ(one_thread, rounded);
    Team team(3);
    const WithTeam with(&team);
    ASSERT_EQ(factorize(factor, m, 0.5, three.data(), room), m.size());
    EXPECT_EQ(three, rounded);
  }
}

bool is_in_a_subtree(const SymbolicFactor& factor, int column) {
  return std::ranges::any_of(factor.subtrees, [&](const Subtree& subtree) {
    const Supernode& root = factor.supernodes[static_cast<std::size_t>(subtree.root)];
    return factor.supernodes[static_cast<std::size_t>(subtree.first)].first <= column &&
           column < root.first + root.columns;
  });
}

/// Which of them is found to fail first is luck.
TEST(Multifrontal, OfSeveralSubtreesThatFailTheFirstCounts) {
  Team team(3);
  int parted = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    SparseSymmetric m = dominated(random_symmetric(seed), seed);
    std::mt19937 random(seed);
    for (int i = 0; i < 5; ++i)
      diagonal(m, std::uniform_int_distribution(0, m.size() - 1)(random)) = -1;
    const SymbolicFactor factor =
        symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
    parted += factor.subtrees.size() > 1 ? 1 : 0;
    std::vector<double> values(factor.values);
    Buffer<std::byte> room;
    const int found = factorize(factor, m, 0, values.data(), room);
    const int first = first_failure(m, factor.order);
    if (is_in_a_subtree(factor, first)) {
      EXPECT_EQ(found, first);
    }
    EXPECT_LT(found, m.size());
    const WithTeam with(&team);
    EXPECT_EQ(factorize(factor, m, 0, values.data(), room), found);
  }
  EXPECT_GT(parted, static_cast<int>(kSeeds) / 2);
}

TEST(Multifrontal, SubtreesBeforeOneThatFailsGoOn) {
  SparseSymmetric m = test::elastic_grid(80);
  const SymbolicFactor factor = symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
  ASSERT_GT(factor.subtrees.size(), 3U);
  const int column = factor.supernodes[static_cast<std::size_t>(factor.subtrees[2].first)].first;
  diagonal(m, 2 * factor.order[static_cast<std::size_t>(column / 2)]) = -1;
  std::vector<double> values(factor.values);
  Buffer<std::byte> room;
  Team team(3);
  const WithTeam with(&team);
  for (int time = 0; time < 10; ++time)  // the first two may be done already
    EXPECT_EQ(factorize(factor, m, 0, values.data(), room), column);
}

TEST(Multifrontal, SubtreesGiveTheSameBitsToAnyNumberOfThreads) {
  Team team(3);
  std::size_t parted = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = dominated(random_symmetric(seed), seed);
    const SymbolicFactor factor =
        symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
    parted += factor.subtrees.size() > 1;
    std::vector<std::vector<double>> found;
    for (Team* asked : {static_cast<Team*>(nullptr), &team}) {
      const WithTeam with(asked);
      std::vector<double> values(factor.values);
      Buffer<std::byte> updates;
      ASSERT_EQ(factorize(factor, m, 0, values.data(), updates), m.size());
      found.push_back(solutions(factor, values.data()));
    }
    EXPECT_EQ(found[0], found[1]);
    const auto x = Eigen::Map<const Eigen::VectorXd>(found[0].data(), m.size());
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(m.size());
    Eigen::VectorXd in_matrix_order(m.size()), image;
    for (int i = 0; i < m.nodes; ++i)
      in_matrix_order.segment<2>(2 * factor.order[static_cast<std::size_t>(i)]) =
          x.segment<2>(2 * i);
    multiply(m, in_matrix_order, image);
    EXPECT_LT((image - ones).norm(), 1e-10 * ones.norm());
  }
  EXPECT_GT(parted, kSeeds / 2);
}

TEST(Multifrontal, UpdateMatricesOfSubtreesHaveTheSameRoomInTurn) {
  const SparseSymmetric m = test::square_pattern(150);
  const SymbolicFactor factor = symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0);
  EXPECT_GT(factor.subtrees.size(), 15U);
  EXPECT_LT(2 * factor.subtree_updates + factor.updates, factor.values / 2);
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
