// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <limits>
#include <random>
#include <string>

#include "core/threads/team.h"

namespace foldless {
namespace {

using Eigen::MatrixXd;

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

MatrixXd random_positive_definite(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const MatrixXd a = MatrixXd::NullaryExpr(size, size, [&] { return unit(random); });
  return a * a.transpose() + MatrixXd::Identity(size, size);
}

/// The first columns of the lower triangle; NaN above, which nothing may read.
MatrixXd panel_of(const MatrixXd& matrix, int columns) {
  MatrixXd panel = matrix.leftCols(columns);
  for (int j = 0; j < columns; ++j) panel.col(j).head(j & ~3).setConstant(kUnset);
  return panel;
}

struct Size {
  int rows, columns;
};
constexpr Size kSizes[] = {{2, 2},   {4, 2},   {6, 4},    {10, 6},    {12, 12},   {30, 14},
                           {64, 64}, {68, 66}, {150, 64}, {202, 130}, {300, 200}, {61 * 2, 58}};

class DenseCholeskyTest : public testing::TestWithParam<const DenseKernels*> {
 protected:
  void SetUp() override {
    if (!GetParam()) GTEST_SKIP() << "this processor does not have them";
  }
  const DenseKernels& kernels() const { return *GetParam(); }
};

TEST_P(DenseCholeskyTest, PanelsAreColumnsOfTheFactor) {
  for (const auto& [rows, columns] : kSizes) {
    SCOPED_TRACE(testing::Message() << rows << " × " << columns);
    const MatrixXd matrix = random_positive_definite(rows, 11);
    MatrixXd panel = panel_of(matrix, columns);
    ASSERT_EQ(factorize_panel({panel.data(), rows, columns}, kernels()), columns);
    const MatrixXd expected = matrix.llt().matrixL();
    for (int j = 0; j < columns; ++j) {
      panel(j, j) = 1 / panel(j, j);
      EXPECT_LT((panel.col(j) - expected.col(j)).tail(rows - j).norm(), 1e-10 * matrix.norm());
    }
  }
}

TEST_P(DenseCholeskyTest, WhatIsTakenOffIsTheSquareOfTheRowsBelow) {
  for (const auto& [rows, columns] : kSizes)
    for (const Square start : {Square::from_zero, Square::accumulate}) {
      const int below = rows - columns;
      SCOPED_TRACE(testing::Message() << rows << " × " << columns);
      MatrixXd panel = random_positive_definite(rows, 12).leftCols(columns);
      const MatrixXd rest = random_positive_definite(below, 13);
      MatrixXd U = start == Square::from_zero ? MatrixXd::Constant(below, below, kUnset) : rest;
      subtract_square({panel.data(), rows, columns}, U.data(), start, kernels());
      const MatrixXd b = panel.bottomRows(below);
      MatrixXd expected = -b * b.transpose();
      if (start == Square::accumulate) expected += rest;
      for (int j = 0; j < below; ++j)
        EXPECT_LT((U.col(j) - expected.col(j)).tail(below - j).norm(), 1e-12 * expected.norm());
    }
}

TEST_P(DenseCholeskyTest, TheFirstColumnWithoutAPositivePivotIsNamed) {
  for (const int column : {0, 1, 2, 5, 63, 64, 66, 101})
    for (const double pivot : {-1.0, 0.0, kUnset}) {
      SCOPED_TRACE(testing::Message() << column << ", " << pivot);
      MatrixXd matrix = MatrixXd::Identity(110, 110);
      matrix(column, column) = pivot;
      matrix(104, 104) = -1;
      EXPECT_EQ(factorize_panel({matrix.data(), 110, 106}, kernels()), column);
    }
}

TEST_P(DenseCholeskyTest, AnyNumberOfThreadsGivesTheSameBits) {
  constexpr int kRows = 700, kColumns = 330, kBelow = kRows - kColumns;
  const MatrixXd matrix = random_positive_definite(kRows, 14);
  MatrixXd panels[2], squares[2];
  Team team(3);
  for (int i = 0; i < 2; ++i) {
    const WithTeam with(i == 0 ? nullptr : &team);
    panels[i] = panel_of(matrix, kColumns);
    squares[i] = MatrixXd::Zero(kBelow, kBelow);
    const DensePanel panel{panels[i].data(), kRows, kColumns};
    ASSERT_EQ(factorize_panel(panel, kernels()), kColumns);
    subtract_square(panel, squares[i].data(), Square::accumulate, kernels());
  }
  for (int j = 0; j < kColumns; ++j)
    EXPECT_EQ(panels[0].col(j).tail(kRows - j), panels[1].col(j).tail(kRows - j)) << j;
  for (int j = 0; j < kBelow; ++j)
    EXPECT_EQ(squares[0].col(j).tail(kBelow - j), squares[1].col(j).tail(kBelow - j)) << j;
}

TEST(DenseKernels, ForAvx2AndAvx512HaveTheSameBits) {
  if (!avx512_kernels()) GTEST_SKIP() << "this processor does not have both";
  for (int rows = 2; rows <= 80; rows += 2)
    for (const int columns : {2, 4, 6, 26}) {
      if (columns > rows) continue;
      SCOPED_TRACE(testing::Message() << rows << " × " << columns);
      const int below = rows - columns;
      const MatrixXd matrix = random_positive_definite(rows, 15);
      MatrixXd panels[2], squares[2];
      for (int i = 0; i < 2; ++i) {
        const DenseKernels& kernels = i == 0 ? *avx2_kernels() : *avx512_kernels();
        // What nothing reads or writes stays as it is, and is compared too.
        panels[i] = matrix.leftCols(columns);
        squares[i] = MatrixXd::Constant(below, below, 1);
        const DensePanel panel{panels[i].data(), rows, columns};
        ASSERT_EQ(factorize_panel(panel, kernels), columns);
        subtract_square(panel, squares[i].data(), Square::from_zero, kernels);
      }
      EXPECT_EQ(panels[0], panels[1]);
      EXPECT_EQ(squares[0], squares[1]);
    }
}

TEST(DenseKernels, AreTheBestThatThereAre) {
  const DenseKernels* best = &plain_kernels;
  for (const DenseKernels* kernels : {neon_kernels(), avx2_kernels(), avx512_kernels()})
    if (kernels) best = kernels;
  EXPECT_EQ(&dense_kernels(), best);
}

std::string name_of(const testing::TestParamInfo<const DenseKernels*>& test) {
  constexpr const char* kNames[] = {"plain", "avx2", "avx512", "neon"};
  return kNames[test.index];
}

INSTANTIATE_TEST_SUITE_P(Kernels, DenseCholeskyTest,
                         testing::Values(&plain_kernels, avx2_kernels(), avx512_kernels(),
                                         neon_kernels()),
                         name_of);

}  // namespace
}  // namespace foldless
