// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/hard_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/bench/random_mesh.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "core/outline/loops.h"

namespace foldless {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Vec2 polar(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

/// With a box of diagonal 1 about the origin, and of the coordinates of the suite.
Points normalised(const Loop& corners) {
  Points points(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = corners[i];
  const Vec2 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  points = (points.colwise() - 0.5 * (low + high)) / (high - low).norm();
  return points.unaryExpr(&suite_coordinate);
}

/// Sides cut into equal parts, the longest parts first, until there are so many corners.
Loop with_corners(const Loop& polygon, int corners) {
  std::vector<int> parts(polygon.size(), 1);
  const auto side = [&](std::size_t i) -> Vec2 {
    return polygon[(i + 1) % polygon.size()] - polygon[i];
  };
  for (auto count = static_cast<int>(polygon.size()); count < corners; ++count) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
      if (side(i).norm() * parts[longest] > side(longest).norm() * parts[i]) longest = i;
    ++parts[longest];
  }
  Loop result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (int part = 0; part < parts[i]; ++part)
      result.push_back(polygon[i] + side(i) * part / parts[i]);
  return result;
}

/// Along the outside of a band round the origin and back along its inside.
template <typename Radius>
Loop band(int corners, double turns, double width, const Radius& radius) {
  const int along = corners / 2;
  Loop polygon;
  for (int i = 0; i < along; ++i) {
    const double angle = kTurn * turns * i / (along - 1);
    polygon.push_back(polar(radius(angle), angle));
  }
  const int back = corners - along;
  for (int i = back - 1; i >= 0; --i) {
    const double angle = kTurn * turns * i / (back - 1);
    polygon.push_back(polar(radius(angle) - width, angle));
  }
  return polygon;
}

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orientation(a, b, c) != orientation(a, b, d) &&
         orientation(c, d, a) != orientation(c, d, b);
}

/// Takes crossings out, each of which makes it shorter.
void untangle(Loop& polygon) {
  const std::size_t n = polygon.size();
  for (bool is_tangled = true; is_tangled;) {
    is_tangled = false;
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j == n - 1) continue;
        if (!cross_each_other(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n]))
          continue;
        std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     polygon.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        is_tangled = true;
      }
  }
}

}  // namespace

Points star_polygon(RandomNumbers& random, int corners) {
  Loop polygon;
  const double depth = random.between(0.1, 0.4);
  for (int i = 0; i < corners; ++i) {
    const double radius = i % 2 == 0 ? random.between(0.6, 1) : random.between(depth, 0.5);
    polygon.push_back(polar(radius, kTurn * i / corners));
  }
  return normalised(polygon);
}

Points comb_polygon(RandomNumbers& random, int corners) {
  const int teeth = random.integer(3, corners / 6);
  const double length = random.between(2, 8);
  Loop polygon{{0, -1}, {2.0 * teeth - 1, -1}};
  for (int tooth = teeth - 1; tooth >= 0; --tooth)
    for (const Vec2& p : {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0, 0)})
      polygon.push_back({2 * tooth + p.x(), p.y() * length * random.between(0.8, 1)});
  return normalised(with_corners(polygon, corners));
}

Points spiral_polygon(RandomNumbers& random, int corners) {
  const double turns = random.between(1, corners / 24.0);
  const double width = random.between(0.3, 0.7);
  return normalised(band(corners, turns, width, [](double angle) { return 1 + angle / kTurn; }));
}

Points random_polygon(RandomNumbers& random, int corners) {
  Loop polygon;
  for (int i = random.integer(12, 24); i > 0; --i) {
    const double x = random.between(0, 1);
    polygon.push_back({x, random.between(0, 1)});
  }
  untangle(polygon);
  if (area_of(polygon) < 0) std::ranges::reverse(polygon);
  return normalised(with_corners(polygon, corners));
}

Points wound_strip_polygon(RandomNumbers& random, int corners) {
  const double turns = random.between(1.1, std::min(2.5, corners / 20.0));
  const double growth = random.between(-0.1, 0.1);
  return normalised(band(corners, turns, 1, [&](double angle) { return 2.5 + growth * angle; }));
}

Points glued_triangles_polygon(RandomNumbers& random, int corners) {
  Points points(2, 3);
  points << 0, 1, 0.5,  //
      0, 0, 0.8;
  Triangles triangles = Eigen::Vector3i(0, 1, 2);
  std::vector<int> loop{0, 1, 2};
  while (static_cast<int>(loop.size()) < corners) {
    const std::size_t side = random.below(loop.size());
    const int i = loop[side], j = loop[(side + 1) % loop.size()];
    const auto apex = static_cast<int>(points.cols());
    const Vec2 way = points.col(j) - points.col(i), right(way.y(), -way.x());
    const double along = random.between(-0.3, 1.3);
    const double away = random.between(0.2, 1.2) / std::max(1.0, way.norm());
    Points more(2, apex + 1);
    more << points, points.col(i) + along * way + away * right;
    Triangles glued(3, triangles.cols() + 1);
    glued << triangles, Eigen::Vector3i(i, apex, j);
    if (!is_injective(glued, more)) continue;
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(side) + 1, apex);
    points = std::move(more);
    triangles = std::move(glued);
  }
  Loop polygon;
  for (const int v : loop) polygon.emplace_back(points.col(v));
  return normalised(polygon);
}

}  // namespace foldless
