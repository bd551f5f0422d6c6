// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/half_precision_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/elimination_tree.h"
#include "core/linear/half_factor.h"
#include "core/linear/multifrontal.h"
#include "core/linear/ordering.h"
#include "core/linear/single_precision_solve.h"
#include "core/linear/sweep.h"
#include "core/linear/symbolic_analysis.h"
#include "core/threads/team.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/support/dense_matrix.h"
#include "tests/support/random_symmetric.h"

namespace foldless {
namespace {

constexpr unsigned kHalfSeeds = 60;
constexpr double kElevenDigits = 1.0 / 2048;

class HalfPrecisionSolve : public testing::Test {
 protected:
  void SetUp() override {
    if (!solves_in_single_precision()) GTEST_SKIP() << "this processor does not";
  }
};

/// A factor that was made in single precision and rounded.
struct Rounded {
  explicit Rounded(const SparseSymmetric& m)
      : symbolic(symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), 0)) {
    Buffer<std::byte> room;
    is_definite = factorize(symbolic, m, 0, half, room) == m.size();
  }

  /// What the work space holds must not matter.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> work(sweep_work_size(symbolic, kSingleOverrun), kNotANumber);
    Eigen::VectorXf x(symbolic.solve_size());
    for (Eigen::Index k = 0; k < b.size(); ++k)
      x[k] = static_cast<float>(b[2 * symbolic.order[static_cast<std::size_t>(k / 2)] + k % 2]);
    triangular_solve_half(symbolic, half, x.data(), work.data());
    Eigen::VectorXd solution(b.size());
    for (Eigen::Index k = 0; k < b.size(); ++k)
      solution[2 * symbolic.order[static_cast<std::size_t>(k / 2)] + k % 2] = x[k];
    return solution;
  }

  SymbolicFactor symbolic;
  HalfFactor half;
  bool is_definite = false;
};

/// ‖A x − b‖ / ‖A‖ ‖x‖, which rounding the values of a factor keeps small however A is conditioned.
double backward_error(const SparseSymmetric& m, const Eigen::VectorXd& x,
                      const Eigen::VectorXd& b) {
  const Eigen::MatrixXd A = test::dense(m);
  return (A * x - b).lpNorm<Eigen::Infinity>() /
         (A.cwiseAbs().rowwise().sum().maxCoeff() * x.lpNorm<Eigen::Infinity>());
}

TEST_F(HalfPrecisionSolve, SolvesToItsElevenDigitsWhateverTheSupernodesAre) {
  std::set<std::pair<int, int>> shapes;  // kinds of columns, rows of the last strip
  for (unsigned seed = 1; seed <= kHalfSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = test::dominated(test::random_symmetric(seed), seed);
    const Rounded rounded(m);
    ASSERT_TRUE(rounded.is_definite);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
    EXPECT_LT(backward_error(m, rounded.solve(b), b), kElevenDigits);
    for (const Supernode& s : rounded.symbolic.supernodes)
      shapes.emplace(s.columns <= 4 ? s.columns : 6 + s.columns % 4, s.below % 8);
  }
  EXPECT_EQ(shapes.size(), 4U * 4U)
      << "two, four, and more columns by fours or with a last two; all ends of strips";
}

TEST_F(HalfPrecisionSolve, SolvesFrontsOfManyColumns) {
  const SparseSymmetric m = test::elastic_grid(30);
  const Rounded rounded(m);
  ASSERT_TRUE(rounded.is_definite);
  EXPECT_GT(rounded.symbolic.largest_front, 60);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  EXPECT_LT(backward_error(m, rounded.solve(b), b), kElevenDigits);
}

/// The inverses of D and the L beside them, which are not rounded to half precision, and what the
/// factor in doubles has there.
struct Heads {
  std::vector<float> half;
  std::vector<double> full;
};

Heads heads(const SymbolicFactor& symbolic, const HalfFactor& half, const double* values) {
  Heads all;
  for (const Supernode& s : symbolic.supernodes)
    for (int j = 0; j < s.columns; ++j) {
      const double* own = values + s.value_start +
                          static_cast<std::size_t>(j) * static_cast<std::size_t>(s.rows() + 1);
      const float* head = half.heads.data() + 4 * static_cast<std::size_t>(s.first + j);
      const int end = std::min(4 - j % 4, s.columns - j);
      for (int d = 0; d < end; ++d) {
        all.half.push_back(head[d]);
        all.full.push_back(own[d] * own[0]);
      }
    }
  return all;
}

TEST_F(HalfPrecisionSolve, IsRoundedFromSinglePrecisionTheSameWayByAnyNumberOfThreads) {
  Team team(3);
  for (unsigned seed = 1; seed <= kHalfSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = test::dominated(test::random_symmetric(seed), seed);
    const Rounded rounded(m);
    Buffer<std::byte> room;
    std::vector<double> values(rounded.symbolic.values);
    ASSERT_EQ(factorize(rounded.symbolic, m, 0, values.data(), room), m.size());
    const Heads all = heads(rounded.symbolic, rounded.half, values.data());
    for (std::size_t i = 0; i < all.half.size(); ++i)
      ASSERT_NEAR(all.half[i], all.full[i], 1e-4 * (1 + std::abs(all.full[i])));
    const WithTeam with(&team);
    const Rounded shared(m);
    ASSERT_TRUE(shared.is_definite);
    EXPECT_EQ(heads(shared.symbolic, shared.half, values.data()).half, all.half);
    EXPECT_TRUE(std::equal(shared.half.strips.data(),
                           shared.half.strips.data() + shared.half.start.back(),
                           rounded.half.strips.data()));
  }
}

TEST_F(HalfPrecisionSolve, ALargePanelIsRoundedByAllThreads) {
  SymbolicFactor one;
  one.supernodes.push_back({.first = 0, .columns = 402, .below = 200});
  one.order.resize(201);
  const Supernode& s = one.supernodes.front();
  const Eigen::MatrixXf panel = Eigen::MatrixXf::Random(s.rows(), s.columns);
  HalfFactor alone, shared;
  make_room(one, alone);
  make_room(one, shared);
  std::fill_n(shared.strips.data(), shared.start.back(), std::uint16_t{1});
  round_panel(one, s, panel.data(), alone);
  Team team(3);
  const WithTeam with(&team);
  round_panel(one, s, panel.data(), shared);
  EXPECT_TRUE(std::equal(alone.strips.data(), alone.strips.data() + alone.start.back(),
                         shared.strips.data()));
  EXPECT_TRUE(
      std::equal(alone.heads.data(), alone.heads.data() + 4 * s.columns, shared.heads.data()));
}

/// S A S, where the stiffest unknown is 10^(4 exponent) times as stiff as the softest, and S.
std::pair<SparseSymmetric, Eigen::VectorXd> graded(SparseSymmetric A, int exponent) {
  Eigen::VectorXd grade(A.size());
  for (int i = 0; i < A.size(); ++i) grade[i] = std::pow(10.0, i % (2 * exponent + 1) - exponent);
  const SparseSymmetric even = A;
  std::size_t k = 0;
  test::for_each_entry(even, [&](int row, int column, double value) {
    A.value[k++] = grade[row] * value * grade[column];
  });
  return {std::move(A), grade};
}

/// Stiff triangles beside soft ones: the digits are those of A, whose S A S is.
TEST_F(HalfPrecisionSolve, HasItsDigitsInAGradedMatrixToo) {
  const SparseSymmetric even = test::dominated(test::random_symmetric(7), 7);
  const auto [m, grade] = graded(even, 2);
  const Rounded rounded(m);
  ASSERT_TRUE(rounded.is_definite);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(even.size(), -1, 2);
  const Eigen::VectorXd x = rounded.solve(grade.cwiseProduct(b)).cwiseProduct(grade);
  EXPECT_LT(backward_error(even, x, b), kElevenDigits);
}

TEST_F(HalfPrecisionSolve, StaysPositiveDefiniteWhereAValueIsTooLarge) {
  const auto [m, grade] = graded(test::dominated(test::random_symmetric(7), 7), 4);
  const Rounded rounded(m);
  ASSERT_TRUE(rounded.is_definite);
  const Eigen::VectorXd b = grade.cwiseProduct(Eigen::VectorXd::LinSpaced(m.size(), -1, 2));
  const Eigen::VectorXd x = rounded.solve(b);
  EXPECT_TRUE(x.allFinite());
  EXPECT_GT(x.dot(b), 0);
}

/// Of a matrix whose factor in half precision differs from the exact one.
class HalfPrecisionPreconditioner : public HalfPrecisionSolve {
 protected:
  void SetUp() override {
    HalfPrecisionSolve::SetUp();
    if (IsSkipped()) return;
    cholesky.analyze(m);
    ASSERT_TRUE(cholesky.factorize(m, 0, Precision::single));
    x = cholesky.precondition(b);
  }

  const SparseSymmetric m = test::elastic_grid(8);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  Cholesky cholesky;
  Eigen::VectorXd x;
};

TEST_F(HalfPrecisionPreconditioner, IsTheFactorInSinglePrecisionRounded) {
  EXPECT_LT((x - Rounded(m).solve(b)).norm(), 1e-5 * x.norm());
  ASSERT_TRUE(cholesky.factorize(m));
  EXPECT_GT((x - cholesky.solve(b)).norm(), 1e-5 * x.norm());
}

TEST_F(HalfPrecisionPreconditioner, IsOfTheLatestFactorAndLeavesThatOfACopy) {
  Cholesky copy = cholesky;
  EXPECT_EQ(copy.precondition(b), x);
  ASSERT_TRUE(copy.factorize(m, 7, Precision::single));
  EXPECT_GT((copy.precondition(b) - x).norm(), 1e-2 * x.norm());
  EXPECT_EQ(cholesky.precondition(b), x);
}

}  // namespace
}  // namespace foldless
