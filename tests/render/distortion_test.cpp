// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/distortion.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render/colormap.h"
#include "tests/support/pixels.h"

namespace foldless {
namespace {

TEST(Distortion, OfAStretchIsItsRatio) {
  Snapshot snapshot = test::undeformed(test::square_grid(4));
  snapshot.deformed.row(0) *= 3;
  for (const double value : distortion_of(snapshot, HeatMeasure::conformal).values)
    EXPECT_NEAR(value, 3, 1e-12);
  for (const double value : distortion_of(snapshot, HeatMeasure::area).values)
    EXPECT_NEAR(value, 3, 1e-12);
}

TEST(Distortion, ScaleAndTurnAreConformal) {
  Snapshot snapshot = test::undeformed(test::hexagon());
  Mat2 turn;
  turn << 1, -2, 2, 1;
  snapshot.deformed = turn * snapshot.deformed;
  const Distortion distortion = distortion_of(snapshot, HeatMeasure::conformal);
  for (const double value : distortion.values) EXPECT_NEAR(value, 1, 1e-12);
  EXPECT_DOUBLE_EQ(distortion.range.min, 1);
  EXPECT_NEAR(distortion_of(snapshot, HeatMeasure::area).values[0], 5, 1e-12);
}

TEST(Distortion, OfEnergiesHasSixDecadesAtMost) {
  const Distortion narrow = distortion_of({0.5, 0.02, 0, 0.1});
  EXPECT_EQ(narrow.range.measure, HeatMeasure::energy);
  EXPECT_DOUBLE_EQ(narrow.range.min, 0.02);
  EXPECT_DOUBLE_EQ(narrow.range.max, 0.5);
  EXPECT_EQ(narrow.range.triangle_at_max, 0);
  EXPECT_EQ(position_on(narrow.range, 0), 0);
  const Distortion wide = distortion_of({1e-20, 3});
  EXPECT_DOUBLE_EQ(wide.range.min, 3e-6);
  const Distortion none = distortion_of({0, 0});
  EXPECT_EQ(position_on(none.range, 0), 0);
}

TEST(Distortion, RangeCoversTheValuesAndNamesTheWorstTriangle) {
  Snapshot snapshot = test::undeformed(test::hexagon());
  snapshot.deformed.col(2) *= 4;
  for (const HeatMeasure measure : {HeatMeasure::conformal, HeatMeasure::area}) {
    const Distortion distortion = distortion_of(snapshot, measure);
    for (const double value : distortion.values) {
      EXPECT_GE(value, distortion.range.min * (1 - 1e-12));
      EXPECT_LE(value, distortion.range.max);
    }
    const auto worst = static_cast<std::size_t>(distortion.range.triangle_at_max);
    EXPECT_DOUBLE_EQ(distortion.values[worst], distortion.range.max);
  }
}

TEST(Distortion, ATriangleThatIsTurnedOverLiesBeyondTheScale) {
  Snapshot snapshot = test::undeformed(test::unit_square());
  snapshot.deformed.col(1) = Vec2(2, 0);
  snapshot.deformed.col(3) = Vec2(0.75, 0.25);
  const Distortion conformal = distortion_of(snapshot, HeatMeasure::conformal);
  EXPECT_LT(conformal.range.max, 10) << "the other triangle alone sets the scale";
  EXPECT_EQ(conformal.range.triangle_at_max, 0);
  EXPECT_EQ(position_on(conformal.range, conformal.values[1]), 1);
  const Distortion area = distortion_of(snapshot, HeatMeasure::area);
  EXPECT_NEAR(area.range.min, 2, 1e-12);
  EXPECT_EQ(position_on(area.range, area.values[1]), 0);
}

TEST(Distortion, RoundingNoiseIsOneColour) {
  Snapshot snapshot = test::undeformed(test::square_grid(5));
  snapshot.deformed.array() += 1e-7 * Eigen::sin(snapshot.deformed.array() * 9);
  const Distortion distortion = distortion_of(snapshot, HeatMeasure::conformal);
  for (const double value : distortion.values)
    EXPECT_LT(position_on(distortion.range, value), 0.01);
}

TEST(HeatRange, IsLogarithmic) {
  const HeatRange range{.min = 1, .max = 100};
  EXPECT_NEAR(position_on(range, 10), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(position_on(range, 0.5), 0);
  EXPECT_DOUBLE_EQ(position_on(range, 1000), 1);
  for (const double t : {0.0, 0.2, 0.9, 1.0})
    EXPECT_NEAR(position_on(range, value_at(range, t)), t, 1e-12);
}

TEST(Viridis, GrowsLighterAllTheWay) {
  const auto luminance = [](float t) {
    return glm::dot(viridis(t), glm::vec3(0.2126F, 0.7152F, 0.0722F));
  };
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(luminance(static_cast<float>(i) / 100), luminance(static_cast<float>(i + 1) / 100));
  EXPECT_EQ(viridis(-1), viridis(0));
  EXPECT_EQ(viridis(2), viridis(1));
}

}  // namespace
}  // namespace foldless
