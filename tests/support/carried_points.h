// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/construct/carried_curves.h"
#include "core/construct/cut_disk.h"

namespace foldless::test {

inline constexpr int kCorners = 12;

/// On the unit circle, then random ones inside.
inline Points dotted_circle(std::uint64_t seed, int inside) {
  Points points(2, kCorners + inside);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    points.col(i) << std::cos(angle), std::sin(angle);
  }
  std::mt19937_64 random(seed);
  const auto any = [&] { return 1.2 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5); };
  for (int i = 0; i < inside; ++i) points.col(kCorners + i) << any(), any();
  return points;
}

inline CarriedCurves curves_of(const Points& points) {
  const auto disk =
      CutDisk::over(points.leftCols(kCorners), points.rightCols(points.cols() - kCorners));
  return {disk.value().triangles(), points};
}

/// In straight lines, in so many steps, each halved where triangles would fold.
inline void go(CarriedCurves& curves, const Points& from, const Points& to, double longest = 0.05) {
  double step = longest;
  for (double time = 0; time < 1;) {
    const double next = std::min(1.0, time + step);
    if (curves.move_to(next == 1 ? to : Points(from + next * (to - from)))) {
      time = next;
      step = longest;
    } else {
      step /= 2;
      ASSERT_GT(step, 1e-9);
    }
  }
}

/// So many turns of the first two points inside about their middle.
inline void twist(CarriedCurves& curves, const Points& home, int turns) {
  const Vec2 middle = 0.5 * (home.col(kCorners) + home.col(kCorners + 1));
  Points from = home;
  for (int i = 1; i <= 24; ++i) {
    const Eigen::Rotation2Dd turned(turns * 2 * std::numbers::pi * i / 24);
    Points to = home;
    for (const int v : {kCorners, kCorners + 1})
      to.col(v) = middle + turned * (home.col(v) - middle);
    if (i == 24) to = home;
    go(curves, from, to);
    from = to;
  }
}

/// Of all curves with edges.
inline int crossings_of(const CarriedCurves& carried) {
  Eigen::Index crossings = 0;
  for (const CarriedCurves::Curve& curve : carried.curves()) crossings += curve.bends.cols();
  return static_cast<int>(crossings);
}

}  // namespace foldless::test
