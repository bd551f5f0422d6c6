// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/convergence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace foldless {
namespace {

const ConvergenceSeries& series(std::string_view name) {
  return *std::ranges::find(convergence_series(), name, &ConvergenceSeries::name);
}

std::vector<Iteration> three_iterations() {
  std::vector<Iteration> iterations(3);
  const std::array flips{2, 2, 7};
  const std::array seconds{0.5, 0.75, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    iterations[i].energy = static_cast<double>(10 - i);
    iterations[i].flips = flips[i];
    iterations[i].seconds = seconds[i];
  }
  return iterations;
}

TEST(Convergence, NamesAreThereOnce) {
  std::set<std::string_view> names;
  for (const ConvergenceSeries& s : convergence_series())
    EXPECT_TRUE(names.insert(s.name).second) << s.name;
}

TEST(Convergence, CountsWhatEachIterationAdds) {
  const auto iterations = three_iterations();
  EXPECT_EQ(values_of(series("energy"), iterations, 9), (std::vector{10.0, 9.0, 8.0}));
  EXPECT_EQ(values_of(series("flips"), iterations, 9), (std::vector{2.0, 0.0, 5.0}));
  EXPECT_EQ(values_of(series("time"), iterations, 9), (std::vector{500.0, 250.0, 250.0}));
}

TEST(Convergence, ATotalThatFallsBeginsAnew) {
  auto iterations = three_iterations();
  iterations[1].flips = 1;
  EXPECT_EQ(values_of(series("flips"), iterations, 9), (std::vector{2.0, 1.0, 6.0}));
  EXPECT_EQ(remeshed_edges(iterations, 1), 1) << "never less than none";
}

TEST(Convergence, StopsWhereItIsAskedTo) {
  EXPECT_EQ(values_of(series("energy"), three_iterations(), 2).size(), 2U);
  EXPECT_TRUE(values_of(series("energy"), {}, 2).empty());
}

}  // namespace
}  // namespace foldless
