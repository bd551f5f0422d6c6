// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/slits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/construct/cut_disk.h"
#include "core/construct/random_numbers.h"

namespace foldless {
namespace {

/// Each takes about the square of the number of points.
constexpr int kPointsOfAllWays = 400;
constexpr int kLeastWays = 6, kMostWays = 8;
/// Points are preferred by factors of up to this.
constexpr double kLargestDelay = 3;

/// Both disks while they are cut. The vertices of points inside are the same in both.
class Cutting {
 public:
  /// `delays`: of the points inside, factors of what slits to them cost.
  Cutting(CutDisk rest, CutDisk deformed, const std::vector<double>& delays)
      : rest_(std::move(rest)),
        deformed_(std::move(deformed)),
        vertex_count_(rest_.vertex_count()) {
    int inside = vertex_count_ - static_cast<int>(delays.size());
    for (const double delay : delays) left_.push_back({inside++, delay, 0});
    vertex_of_.resize(static_cast<std::size_t>(vertex_count_));
    for (int v = 0; v < vertex_count_; ++v) vertex_of_[static_cast<std::size_t>(v)] = v;
  }

  /// What slits cost was a bound for what they cost now where no slit came near.
  bool cut_all() {
    for (Left& left : left_) left.cost = left.delay * best_of(left.vertex).cost;
    while (!left_.empty()) {
      const auto next = std::ranges::min_element(left_, {}, &Left::cost);
      const Slit slit = best_of(next->vertex);
      if (slit.corner < 0) return false;
      const double cost = next->cost;
      next->cost = next->delay * slit.cost;
      if (next->cost > cost && std::ranges::min_element(left_, {}, &Left::cost) != next) continue;
      const int v = next->vertex;
      left_.erase(next);
      cut(v, slit);
      length_ += slit.cost;
    }
    return true;
  }

  SlitDisks slit_disks() const {
    SlitDisks result;
    result.vertex_count = vertex_count_;
    result.length = length_;
    for (const int v : rest_.outline())
      result.vertices.push_back(vertex_of_[static_cast<std::size_t>(rest_.origin(v))]);
    result.rest = outline_of(rest_);
    result.deformed = outline_of(deformed_);
    result.rest_triangles = triangles_of(rest_);
    result.deformed_triangles = triangles_of(deformed_);
    return result;
  }

 private:
  struct Left {
    int vertex;
    double delay;
    double cost;  ///< as it was last worked out, with the delay
  };
  struct Slit {
    double cost = std::numeric_limits<double>::infinity();
    int corner = -1;  ///< index of outlines
    CutDisk::Ways rest, deformed;
  };

  Slit best_of(int v) const {
    Slit slit{.rest = rest_.ways_to(v), .deformed = deformed_.ways_to(v)};
    const std::vector<int>&at_rest = rest_.outline(), &deformed = deformed_.outline();
    for (std::size_t i = 0; i < at_rest.size(); ++i) {
      const double cost = slit.rest.cost(at_rest[i]) + slit.deformed.cost(deformed[i]);
      if (cost >= slit.cost) continue;
      slit.cost = cost;
      slit.corner = static_cast<int>(i);
    }
    return slit;
  }

  void cut(int v, const Slit& slit) {
    const auto corner = static_cast<std::size_t>(slit.corner);
    const auto at_rest = rest_.way_from(rest_.outline()[corner], slit.rest);
    const auto deformed = deformed_.way_from(deformed_.outline()[corner], slit.deformed);
    const int between = static_cast<int>(std::max(at_rest.crossed.size(), deformed.crossed.size()));
    const int old_at_rest = rest_.vertex_count(), old_deformed = deformed_.vertex_count();
    const std::vector<int> bends = rest_.cut(at_rest, v, between);
    deformed_.cut(deformed, v, between);
    vertex_of_.resize(static_cast<std::size_t>(rest_.vertex_count()), -1);
    for (std::size_t i = 1; i + 1 < bends.size(); ++i)
      vertex_of_[static_cast<std::size_t>(bends[i])] = vertex_count_++;
    for (Left& left : left_)
      if (rest_.is_beside(left.vertex, old_at_rest, v) ||
          deformed_.is_beside(left.vertex, old_deformed, v))
        left.cost = 0;
  }

  static Points outline_of(const CutDisk& disk) {
    Points points(2, static_cast<Eigen::Index>(disk.outline().size()));
    Eigen::Index next = 0;
    for (const int v : disk.outline()) points.col(next++) = disk.position(v);
    return points;
  }
  static Triangles triangles_of(const CutDisk& disk) {
    std::vector<int> corner(static_cast<std::size_t>(disk.vertex_count()), -1);
    for (std::size_t i = 0; i < disk.outline().size(); ++i)
      corner[static_cast<std::size_t>(disk.outline()[i])] = static_cast<int>(i);
    Triangles triangles(3, static_cast<Eigen::Index>(disk.triangles().size()));
    Eigen::Index next = 0;
    for (const Eigen::Vector3i& t : disk.triangles()) {
      Eigen::Vector3i corners =
          t.unaryExpr([&](int v) { return corner[static_cast<std::size_t>(v)]; });
      std::ranges::sort(corners);
      triangles.col(next++) = corners;
    }
    return triangles;
  }

  CutDisk rest_, deformed_;
  std::vector<Left> left_;      ///< inside
  std::vector<int> vertex_of_;  ///< of the result, by vertex at rest; −1: of a copy
  int vertex_count_;            ///< of the result
  double length_ = 0;
};

}  // namespace

std::vector<SlitDisks> slit_open(const DottedDisk& rest, const DottedDisk& deformed) {
  const std::optional<CutDisk> at_rest = CutDisk::over(rest.outline, rest.inside);
  if (!at_rest) return {};
  const std::optional<CutDisk> image = CutDisk::over(deformed.outline, deformed.inside);
  if (!image) return {};
  const int points = static_cast<int>(rest.inside.cols());
  std::vector<SlitDisks> ways;
  ConstructionRandom random(1);
  for (int way = 0; way < std::clamp(kPointsOfAllWays / points, kLeastWays, kMostWays); ++way) {
    std::vector<double> delays(static_cast<std::size_t>(points), 1);
    if (way > 0)
      for (double& delay : delays) delay = std::pow(kLargestDelay, random.uniform());
    Cutting cutting(*at_rest, *image, delays);
    if (cutting.cut_all()) ways.push_back(cutting.slit_disks());
  }
  std::ranges::stable_sort(ways, {}, &SlitDisks::length);
  const auto are_equal = [](const SlitDisks& a, const SlitDisks& b) {
    return a.length == b.length;
  };
  ways.erase(std::unique(ways.begin(), ways.end(), are_equal), ways.end());
  return ways;
}

}  // namespace foldless
