// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/corner_order.h"

#include <algorithm>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

bool is_before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Directions from an apex, sorted counter-clockwise from that to a start.
class Directions {
 public:
  Directions(const Vec2& apex, const Vec2& start) : apex_(apex), start_(start) {}

  /// −1, 0, 1: the direction to a comes before that to b, is the same, comes after it.
  int compare(const Vec2& a, const Vec2& b) const {
    const int half_a = half_of(a), half_b = half_of(b);
    return half_a != half_b ? half_a - half_b : -orientation(apex_, a, b);
  }

 private:
  /// 0 in the half turn from the start on, 1 from straight back on.
  int half_of(const Vec2& p) const {
    const int side = orientation(apex_, start_, p);
    const bool is_ahead = is_before(apex_, p) == is_before(apex_, start_);
    return side > 0 || (side == 0 && is_ahead) ? 0 : 1;
  }

  const Vec2& apex_;
  const Vec2& start_;
};

}  // namespace

CornerOrder::CornerOrder(const Points& polygon, StraightBack tips)
    : polygon_(polygon), places_(Eigen::MatrixXi::Constant(polygon.cols(), polygon.cols(), -1)) {
  for (int v = 0; v < corners(); ++v) sort_round(v, tips);
}

void CornerOrder::sort_round(int v, StraightBack tips) {
  const int next = (v + 1) % corners(), previous = (v + corners() - 1) % corners();
  const Vec2 apex = polygon_.col(v), start = polygon_.col(next);
  if (start == apex || polygon_.col(previous) == apex) return;
  const Directions directions(apex, start);
  const auto compare = [&](int a, int b) {
    return directions.compare(polygon_.col(a), polygon_.col(b));
  };
  std::vector<int> others;
  for (int w = 0; w < corners(); ++w)
    if (polygon_.col(w) != apex) others.push_back(w);
  std::ranges::sort(others, [&](int a, int b) { return compare(a, b) < 0; });
  const bool is_full = tips == StraightBack::full_turn && compare(next, previous) == 0;
  const auto is_inside = [&](int w) { return is_full || compare(w, previous) < 0; };
  int place = 0;
  for (std::size_t i = 0; i < others.size() && is_inside(others[i]); ++i) {
    if (i > 0 && compare(others[i - 1], others[i]) != 0) ++place;
    if (place > 0) places_(others[i], v) = place;
  }
  places_(next, v) = 0;
  if (is_inside(next)) places_(previous, v) = place + 1;
}

bool CornerOrder::is_piece(int i, int j, int k) const {
  const auto leaves_in_order = [this](int v, int first, int second) {
    return place(v, first) >= 0 && place(v, first) < place(v, second);
  };
  return leaves_in_order(i, j, k) && leaves_in_order(j, k, i) && leaves_in_order(k, i, j) &&
         orientation(polygon_.col(i), polygon_.col(j), polygon_.col(k)) > 0;
}

}  // namespace foldless
