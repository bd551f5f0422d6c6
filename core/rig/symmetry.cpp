// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rig/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace foldless {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kCells = 96;  ///< along the longer side
/// An axis is another one's better by this part of the area; less is what cells make of it.
constexpr double kBetter = 3e-3;

Vec2 middle_of(const Triangles& triangles, const Points& rest) {
  Vec2 sum = Vec2::Zero();
  double area = 0;
  for (const auto& t : triangles.colwise()) {
    const double part = signed_area(rest, t);
    area += part;
    sum += part * (rest.col(t[0]) + rest.col(t[1]) + rest.col(t[2])) / 3;
  }
  return sum / area;
}

/// Which cells of a grid over the mesh have their middle in it.
class Cover {
 public:
  Cover(const Triangles& triangles, const Points& rest) {
    const Vec2 low = rest.rowwise().minCoeff(), high = rest.rowwise().maxCoeff();
    cell_ = (high - low).maxCoeff() / kCells;
    origin_ = low - Vec2::Constant(cell_);
    columns_ = static_cast<int>((high - low).x() / cell_) + 3;
    rows_ = static_cast<int>((high - low).y() / cell_) + 3;
    covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (const auto& t : triangles.colwise()) fill(rest.col(t[0]), rest.col(t[1]), rest.col(t[2]));
  }

  /// The part of it that lies over it when mirrored.
  double agreement(const MirrorAxis& axis) const {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        if (at(x, y) == 0) continue;
        sum += between(mirrored(axis, middle(x, y)));
        ++count;
      }
    return count > 0 ? sum / count : 0;
  }

 private:
  Vec2 middle(int x, int y) const { return origin_ + cell_ * Vec2(x + 0.5, y + 0.5); }
  double at(int x, int y) const {
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return 0;
    return covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(x)];
  }
  /// Bilinear between the middles of cells.
  double between(const Vec2& point) const {
    const Vec2 p = (point - origin_) / cell_ - Vec2::Constant(0.5);
    const double x = std::floor(p.x()), y = std::floor(p.y());
    const double s = p.x() - x, t = p.y() - y;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }
  void fill(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 low = (a.cwiseMin(b).cwiseMin(c) - origin_) / cell_;
    const Vec2 high = (a.cwiseMax(b).cwiseMax(c) - origin_) / cell_;
    for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y)
      for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x) {
        const Vec2 p = middle(x, y);
        if (signed_area(a, b, p) < 0 || signed_area(b, c, p) < 0 || signed_area(c, a, p) < 0)
          continue;
        covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                 static_cast<std::size_t>(x)] = 1;
      }
  }

  double cell_ = 1;
  Vec2 origin_ = Vec2::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<double> covered_;
};

/// An axis by its angle from upright, counter-clockwise, and its distance from the middle.
struct Candidate {
  double degrees = 0;
  double offset = 0;  ///< [length]

  Vec2 along() const {
    const double angle = (90 + degrees) * kDegree;
    // Upright and level are so exactly.
    if (degrees == 0) return Vec2::UnitY();
    if (degrees == 90) return -Vec2::UnitX();
    return {std::cos(angle), std::sin(angle)};
  }
  MirrorAxis axis(const Vec2& middle) const {
    const Vec2 from = middle + offset * Vec2(along().y(), -along().x());
    return {from, from + along()};
  }
};

/// From one side of the mesh to the other.
MirrorAxis as_long_as(const Points& rest, const MirrorAxis& axis) {
  const Vec2 along = (axis.to - axis.from).normalized();
  const Eigen::RowVectorXd places = along.transpose() * (rest.colwise() - axis.from);
  return {axis.from + places.minCoeff() * along, axis.from + places.maxCoeff() * along};
}

/// Goes from a candidate to better ones near it as long as there are some.
Candidate refined(Candidate best, const Cover& cover, const Vec2& middle, double length) {
  double most = cover.agreement(best.axis(middle)) + kBetter;
  for (double scale = 1; scale > 0.05; scale /= 2) {
    bool is_better = true;
    while (is_better) {
      is_better = false;
      const double turn = 1.5 * scale, shift = 0.01 * scale * length;
      for (const auto& [degrees, offset] :
           std::array<Candidate, 4>{{{turn, 0}, {-turn, 0}, {0, shift}, {0, -shift}}}) {
        const Candidate next{best.degrees + degrees, best.offset + offset};
        const double agreement = cover.agreement(next.axis(middle));
        if (agreement <= most) continue;
        most = agreement;
        best = next;
        is_better = true;
      }
    }
  }
  return best;
}

}  // namespace

MirrorAxis axis_through_middle(const Triangles& triangles, const Points& rest,
                               const Vec2& direction) {
  const Vec2 middle = middle_of(triangles, rest);
  return as_long_as(rest, {middle, middle + direction.normalized()});
}

MirrorAxis symmetry_axis(const Triangles& triangles, const Points& rest) {
  const Vec2 middle = middle_of(triangles, rest);
  const Cover cover(triangles, rest);
  Candidate best;
  double most = cover.agreement(best.axis(middle)) + kBetter;
  const auto offer = [&](double degrees) {
    const Candidate candidate{degrees, 0};
    const double agreement = cover.agreement(candidate.axis(middle));
    if (agreement <= most) return;
    most = agreement + kBetter;
    best = candidate;
  };
  offer(90);
  for (int degrees = -87; degrees < 90; degrees += 3)
    if (degrees != 0) offer(degrees);
  const double length = (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm();
  return as_long_as(rest, refined(best, cover, middle, length).axis(middle));
}

}  // namespace foldless
