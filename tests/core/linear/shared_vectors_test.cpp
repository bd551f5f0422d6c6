// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/shared_vectors.h"

#include <gtest/gtest.h>

#include "core/threads/team.h"
#include "tests/core/linear/random_values.h"

namespace foldless {
namespace {

constexpr int kVectorSizes[] = {0, 1, 4095, 4096, 4097, 20001};

TEST(SharedVectors, AreThoseOfTheLinearAlgebra) {
  for (const int size : kVectorSizes) {
    SCOPED_TRACE(size);
    const Eigen::VectorXd a = test::random_values(size, 1), b = test::random_values(size, 2);
    EXPECT_NEAR(shared_dot(a, b), a.dot(b), 1e-13 * size);
    Eigen::VectorXd sum = b;
    add_multiple(-0.3, a, sum);
    EXPECT_EQ(sum, Eigen::VectorXd(b - 0.3 * a));
    EXPECT_EQ(sum_with_multiple(b, -0.3, a), sum);
    Eigen::VectorXd made;
    subtract(a, b, made);
    EXPECT_EQ(made, Eigen::VectorXd(a - b));
    copy(a, made);
    EXPECT_EQ(made, a);
    EXPECT_EQ(largest_difference(a, b), size == 0 ? 0 : (a - b).lpNorm<Eigen::Infinity>());
    EXPECT_EQ(largest_magnitude(a), a.lpNorm<Eigen::Infinity>());
    EXPECT_EQ(largest_magnitude(-a), a.lpNorm<Eigen::Infinity>());
  }
}

TEST(SharedVectors, HaveTheSameBitsWithAnyNumberOfThreads) {
  for (const int size : kVectorSizes) {
    SCOPED_TRACE(size);
    const Eigen::VectorXd a = test::random_values(size, 3), b = test::random_values(size, 4);
    Eigen::VectorXd alone = b, shared = b;
    const double dot = shared_dot(a, b), difference = largest_difference(a, b);
    add_multiple(7, a, alone);
    Team team(3);
    const WithTeam with(&team);
    EXPECT_EQ(shared_dot(a, b), dot);
    add_multiple(7, a, shared);
    EXPECT_EQ(shared, alone);
    EXPECT_EQ(sum_with_multiple(b, 7, a), alone);
    EXPECT_EQ(largest_difference(a, b), difference);
    Eigen::VectorXd made;
    subtract(a, b, made);
    EXPECT_EQ(made, Eigen::VectorXd(a - b));
    copy(a, made);
    EXPECT_EQ(made, a);
  }
}

TEST(SharedVectors, AreOfAnyShape) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(2, 5000), b = Eigen::MatrixXd::Random(2, 5000);
  EXPECT_EQ(sum_with_multiple(a, 0.5, b), Eigen::MatrixXd(a + 0.5 * b));
  EXPECT_EQ(largest_difference(a, b), (a - b).cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace foldless
