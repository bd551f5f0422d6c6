// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads/zeros.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace foldless {
namespace {

TEST(Zeros, AreOfAnyShapeAndMadeByAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    Team team(threads);
    const WithTeam with(&team);
    for (const int size : {0, 1, 4096, 4097, 20'001}) {
      SCOPED_TRACE(size);
      { const Eigen::VectorXd used = Eigen::VectorXd::Ones(size); }  // memory that is not zero
      EXPECT_EQ(zeros<Eigen::VectorXd>(size), Eigen::VectorXd::Zero(size));
      EXPECT_EQ(zeros<Eigen::Matrix2Xd>(2, size), Eigen::Matrix2Xd::Zero(2, size));
    }
  }
}

}  // namespace
}  // namespace foldless
