// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <limits>
#include <random>

#include "core/threads/team.h"

namespace foldless {
namespace {

template <class Value>
using Matrix = Eigen::MatrixX<Value>;
template <class Value>
constexpr Value kInfinite = std::numeric_limits<Value>::infinity();
template <class Value>
constexpr Value kUnset = std::numeric_limits<Value>::quiet_NaN();
/// Of what is computed in so many operations as below, by the norm of a column.
template <class Value>
constexpr Value kRounding = 20 * std::numeric_limits<Value>::epsilon();

template <class Value>
Matrix<Value> random_positive_definite(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return unit(random); });
  return (a + a.transpose() + 2 * size * Eigen::MatrixXd::Identity(size, size)).cast<Value>();
}

/// The first columns of the lower triangle; NaN above, which nothing may read.
template <class Value>
Matrix<Value> panel_of(const Matrix<Value>& matrix, int columns) {
  Matrix<Value> panel = matrix.leftCols(columns);
  for (int j = 0; j < columns; ++j) panel.col(j).head(j & ~3).setConstant(kUnset<Value>);
  return panel;
}

struct Size {
  int rows, columns;
};
constexpr Size kSizes[] = {{2, 2},   {4, 2},   {6, 4},    {10, 6},    {12, 12},   {30, 14},
                           {64, 64}, {68, 66}, {150, 64}, {202, 130}, {300, 200}, {61 * 2, 58}};

template <class Value>
const DenseKernels<Value>* kernels_for_all() {
  return &plain_kernels<Value>();
}

template <class ValueOf, const DenseKernels<ValueOf>* (*Kernels)()>
struct KindOfKernels {
  using Value = ValueOf;
  static const DenseKernels<Value>* kernels() { return Kernels(); }
};

template <class Kind>
class DenseCholeskyTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!Kind::kernels()) GTEST_SKIP() << "this processor does not have them";
  }
  const DenseKernels<typename Kind::Value>& kernels() const { return *Kind::kernels(); }
};

using KindsOfKernels = testing::Types<
    KindOfKernels<double, kernels_for_all<double>>, KindOfKernels<double, avx2_kernels<double>>,
    KindOfKernels<double, avx512_kernels<double>>, KindOfKernels<double, neon_kernels<double>>,
    KindOfKernels<float, kernels_for_all<float>>, KindOfKernels<float, avx2_kernels<float>>,
    KindOfKernels<float, avx512_kernels<float>>>;
TYPED_TEST_SUITE(DenseCholeskyTest, KindsOfKernels);

TYPED_TEST(DenseCholeskyTest, PanelsAreColumnsOfTheFactor) {
  using Value = typename TypeParam::Value;
  for (const auto& [rows, columns] : kSizes) {
    SCOPED_TRACE(testing::Message() << rows << " × " << columns);
    const Matrix<Value> matrix = random_positive_definite<Value>(rows, 11);
    Matrix<Value> panel = panel_of(matrix, columns);
    ASSERT_EQ(factorize_panel(DensePanel<Value>{panel.data(), rows, columns}, this->kernels()),
              columns);
    const Matrix<Value> expected = matrix.llt().matrixL();
    for (int j = 0; j < columns; ++j) {
      panel(j, j) = 1 / panel(j, j);
      EXPECT_LT((panel.col(j) - expected.col(j)).tail(rows - j).norm(),
                kRounding<Value> * expected.col(j).norm());
    }
  }
}

TYPED_TEST(DenseCholeskyTest, WhatIsTakenOffIsTheSquareOfTheRowsBelow) {
  using Value = typename TypeParam::Value;
  for (const auto& [rows, columns] : kSizes)
    for (const Square start : {Square::from_zero, Square::accumulate}) {
      const int below = rows - columns;
      SCOPED_TRACE(testing::Message() << rows << " × " << columns);
      Matrix<Value> panel = random_positive_definite<Value>(rows, 12).leftCols(columns);
      const Matrix<Value> rest = random_positive_definite<Value>(below, 13);
      Matrix<Value> U =
          start == Square::from_zero ? Matrix<Value>::Constant(below, below, kUnset<Value>) : rest;
      subtract_square(DensePanel<Value>{panel.data(), rows, columns}, U.data(), start,
                      this->kernels());
      const Matrix<Value> b = panel.bottomRows(below);
      Matrix<Value> expected = -b * b.transpose();
      if (start == Square::accumulate) expected += rest;
      for (int j = 0; j < below; ++j)
        EXPECT_LT((U.col(j) - expected.col(j)).tail(below - j).norm(),
                  kRounding<Value> * expected.col(j).norm());
    }
}

TYPED_TEST(DenseCholeskyTest, TheFirstColumnWithoutAPositivePivotIsNamed) {
  using Value = typename TypeParam::Value;
  for (const int column : {0, 1, 2, 5, 63, 64, 66, 101})
    for (const Value pivot : {Value{-1}, Value{0}, kUnset<Value>, kInfinite<Value>}) {
      SCOPED_TRACE(testing::Message() << column << ", " << pivot);
      Matrix<Value> matrix = Matrix<Value>::Identity(110, 110);
      matrix(column, column) = pivot;
      matrix(104, 104) = -1;
      EXPECT_EQ(factorize_panel(DensePanel<Value>{matrix.data(), 110, 106}, this->kernels()),
                column);
    }
}

TYPED_TEST(DenseCholeskyTest, AnyNumberOfThreadsGivesTheSameBits) {
  using Value = typename TypeParam::Value;
  constexpr int kRows = 700, kColumns = 330, kBelow = kRows - kColumns;
  const Matrix<Value> matrix = random_positive_definite<Value>(kRows, 14);
  Matrix<Value> panels[2], squares[2];
  Team team(3);
  for (int i = 0; i < 2; ++i) {
    const WithTeam with(i == 0 ? nullptr : &team);
    panels[i] = panel_of(matrix, kColumns);
    squares[i] = Matrix<Value>::Zero(kBelow, kBelow);
    const DensePanel<Value> panel{panels[i].data(), kRows, kColumns};
    ASSERT_EQ(factorize_panel(panel, this->kernels()), kColumns);
    subtract_square(panel, squares[i].data(), Square::accumulate, this->kernels());
  }
  for (int j = 0; j < kColumns; ++j)
    EXPECT_EQ(panels[0].col(j).tail(kRows - j), panels[1].col(j).tail(kRows - j)) << j;
  for (int j = 0; j < kBelow; ++j)
    EXPECT_EQ(squares[0].col(j).tail(kBelow - j), squares[1].col(j).tail(kBelow - j)) << j;
}

template <class Value>
class DenseKernelsTest : public testing::Test {};
using BothValues = testing::Types<double, float>;
TYPED_TEST_SUITE(DenseKernelsTest, BothValues);

TYPED_TEST(DenseKernelsTest, ForAvx2AndAvx512HaveTheSameBits) {
  using Value = TypeParam;
  if (!avx512_kernels<Value>()) GTEST_SKIP() << "this processor does not have both";
  for (int rows = 2; rows <= 120; rows += 2)
    for (const int columns : {2, 4, 6, 26}) {
      if (columns > rows) continue;
      SCOPED_TRACE(testing::Message() << rows << " × " << columns);
      const int below = rows - columns;
      const Matrix<Value> matrix = random_positive_definite<Value>(rows, 15);
      Matrix<Value> panels[2], squares[2];
      for (int i = 0; i < 2; ++i) {
        const DenseKernels<Value>& kernels =
            i == 0 ? *avx2_kernels<Value>() : *avx512_kernels<Value>();
        // What nothing reads or writes stays as it is, and is compared too.
        panels[i] = matrix.leftCols(columns);
        squares[i] = Matrix<Value>::Constant(below, below, 1);
        const DensePanel<Value> panel{panels[i].data(), rows, columns};
        ASSERT_EQ(factorize_panel(panel, kernels), columns);
        subtract_square(panel, squares[i].data(), Square::from_zero, kernels);
      }
      EXPECT_EQ(panels[0], panels[1]);
      EXPECT_EQ(squares[0], squares[1]);
    }
}

TYPED_TEST(DenseKernelsTest, AreTheBestThatThereAre) {
  using Value = TypeParam;
  const DenseKernels<Value>* best = &plain_kernels<Value>();
  for (const DenseKernels<Value>* kernels :
       {neon_kernels<Value>(), avx2_kernels<Value>(), avx512_kernels<Value>()})
    if (kernels) best = kernels;
  EXPECT_EQ(&dense_kernels<Value>(), best);
}

}  // namespace
}  // namespace foldless
