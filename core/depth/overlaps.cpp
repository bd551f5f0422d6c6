// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace foldless {
namespace {

using Boxes = std::vector<Eigen::AlignedBox2d>;

/// Penetration this small, of the size of the triangles, is rounding.
constexpr double kTouching = 1e-9;
/// Cells in all, and cells that triangles lie in, for every triangle at most.
constexpr double kMostCells = 8;

/// A grid of square cells over the mesh; triangles are in all cells that their boxes touch.
class Grid {
 public:
  explicit Grid(const Boxes& boxes) : boxes_(boxes) {
    Eigen::AlignedBox2d whole;
    double extents = 0;
    for (const auto& box : boxes) {
      whole.extend(box);
      extents += box.sizes().sum();
    }
    origin_ = whole.min();
    const auto count = static_cast<double>(boxes.size());
    cell_ = std::max({0.5 * extents / count, std::sqrt(whole.sizes().prod() / (kMostCells * count)),
                      whole.sizes().maxCoeff() / (kMostCells * count)});
    if (!(cell_ > 0)) cell_ = 1;
    while (cells_of_boxes() > kMostCells * count) cell_ *= 2;
    columns_ = column(whole.max().x()) + 1;
    const std::int64_t rows = row(whole.max().y()) + 1;
    first_.assign(static_cast<std::size_t>(columns_ * rows) + 1, 0);
    for_each_cell([this](std::size_t cell, int) { ++first_[cell + 1]; });
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    triangles_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for_each_cell(
        [&](std::size_t cell, int t) { triangles_[static_cast<std::size_t>(next[cell]++)] = t; });
  }

  /// Every pair of triangles whose boxes intersect, once.
  template <class Function>
  void for_each_pair(const Function& function) const {
    for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell)
      for (int i = first_[cell]; i < first_[cell + 1]; ++i)
        for (int j = i + 1; j < first_[cell + 1]; ++j) {
          const int a = triangles_[static_cast<std::size_t>(i)];
          const int b = triangles_[static_cast<std::size_t>(j)];
          const auto& box = boxes_[static_cast<std::size_t>(a)];
          const auto& other = boxes_[static_cast<std::size_t>(b)];
          if (!box.intersects(other)) continue;
          const Vec2 corner = box.min().cwiseMax(other.min());
          if (cell_at(column(corner.x()), row(corner.y())) == cell) function(a, b);
        }
  }

 private:
  std::int64_t column(double x) const {
    return static_cast<std::int64_t>((x - origin_.x()) / cell_);
  }
  std::int64_t row(double y) const { return static_cast<std::int64_t>((y - origin_.y()) / cell_); }
  std::size_t cell_at(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  double cells_of_boxes() const {
    double count = 0;
    for (const auto& box : boxes_)
      count += (box.sizes().x() / cell_ + 1) * (box.sizes().y() / cell_ + 1);
    return count;
  }

  template <class Function>
  void for_each_cell(const Function& function) const {
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      const auto& box = boxes_[t];
      for (auto y = row(box.min().y()); y <= row(box.max().y()); ++y)
        for (auto x = column(box.min().x()); x <= column(box.max().x()); ++x)
          function(cell_at(x, y), static_cast<int>(t));
    }
  }

  const Boxes& boxes_;
  Vec2 origin_;
  double cell_ = 1;
  std::int64_t columns_ = 0;
  std::vector<int> first_;  ///< cell → its entries in `triangles_`
  std::vector<int> triangles_;
};

bool have_common_corner(const Triangles& triangles, int a, int b) {
  for (const int v : triangles.col(a))
    if (v == triangles(0, b) || v == triangles(1, b) || v == triangles(2, b)) return true;
  return false;
}

enum class Meeting { apart, contact, overlap };

/// How the second triangle lies to the edges of the first.
Meeting meeting_at_edges(const Triangles& triangles, const Points& points, int a, int b) {
  Meeting meeting = Meeting::overlap;
  for (int k = 0; k < 3; ++k) {
    const Vec2 start = points.col(triangles(k, a));
    const Vec2 along = points.col(triangles((k + 1) % 3, a)) - start;
    double inwards = -std::numeric_limits<double>::infinity(), reach = 0;
    for (const int v : triangles.col(b)) {
      const Vec2 way = points.col(v) - start;
      inwards = std::max(inwards, cross(along, way));
      reach = std::max(reach, way.lpNorm<1>());
    }
    const double rounding = kTouching * along.lpNorm<1>() * reach;
    if (inwards < -rounding) return Meeting::apart;
    if (inwards <= rounding) meeting = Meeting::contact;
  }
  return meeting;
}

}  // namespace

std::vector<Overlap> overlapping_triangles(const Triangles& triangles, const Points& points,
                                           CommonCorners corners) {
  if (triangles.cols() == 0) return {};
  Boxes boxes(static_cast<std::size_t>(triangles.cols()));
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (const int v : triangles.col(static_cast<Eigen::Index>(t))) boxes[t].extend(points.col(v));
  std::vector<Overlap> overlaps;
  Grid(boxes).for_each_pair([&](int a, int b) {
    const bool are_neighbours = have_common_corner(triangles, a, b);
    if (are_neighbours && corners == CommonCorners::apart) return;
    const Meeting meeting = std::min(meeting_at_edges(triangles, points, a, b),
                                     meeting_at_edges(triangles, points, b, a));
    if (meeting == Meeting::apart || (meeting == Meeting::contact && are_neighbours)) return;
    overlaps.push_back({std::min(a, b), std::max(a, b), meeting == Meeting::contact});
  });
  std::ranges::sort(overlaps, {}, [](const Overlap& o) { return std::tuple(o.a, o.b); });
  return overlaps;
}

}  // namespace foldless
