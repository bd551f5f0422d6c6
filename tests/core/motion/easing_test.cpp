// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/easing.h"

#include <gtest/gtest.h>

#include <random>

namespace foldless {
namespace {

TEST(Easing, BeginsAtZeroAndEndsAtOne) {
  for (const NamedEasing& row : easings()) {
    EXPECT_EQ(row.easing.at(0), 0) << row.name;
    EXPECT_EQ(row.easing.at(1), 1) << row.name;
  }
}

TEST(Easing, HasTheShapeOfItsName) {
  const auto at = [](std::string_view name, double time) { return find_easing(name)->at(time); };
  EXPECT_EQ(at("linear", 0.3), 0.3);
  EXPECT_EQ(at("hold", 0.999), 0);
  EXPECT_LT(at("in", 0.25), 0.15);
  EXPECT_GT(at("out", 0.25), 0.35);
  EXPECT_LT(at("both", 0.25), 0.2);
  EXPECT_GT(at("both", 0.75), 0.8);
  EXPECT_NEAR(at("both", 0.5), 0.5, 1e-15);
  EXPECT_EQ(find_easing("bounce"), std::nullopt);
}

TEST(Easing, AgreesWithTheCurveThatItIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1), any(-1, 2);
  for (int trial = 0; trial < 200; ++trial) {
    Easing easing{{unit(random), any(random)}, {unit(random), any(random)}};
    for (const double s : {0.1, 0.35, 0.5, 0.8, 0.99}) {
      const double r = 1 - s;
      const Vec2 point =
          3 * r * r * s * easing.first + 3 * r * s * s * easing.second + s * s * s * Vec2(1, 1);
      EXPECT_NEAR(easing.at(point.x()), point.y(), 1e-4) << "trial " << trial << ", s = " << s;
    }
  }
}

TEST(Easing, KnowsItsName) {
  for (const NamedEasing& row : easings()) EXPECT_EQ(name_of(row.easing), row.name);
  EXPECT_EQ(name_of({{0.1, 0}, {0.9, 1}}), "");
}

}  // namespace
}  // namespace foldless
