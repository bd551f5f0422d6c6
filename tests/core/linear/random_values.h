// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>

namespace foldless::test {

/// So many numbers of −1 … 1.
inline Eigen::VectorXd random_values(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd values(count);
  for (double& value : values) value = unit(random);
  return values;
}

}  // namespace foldless::test
