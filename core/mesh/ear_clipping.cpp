// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ear_clipping.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

using Piece = std::array<int, 3>;

bool less_xy(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Precondition: p is on the line through a and b.
bool is_between(const Vec2& p, const Vec2& a, const Vec2& b) {
  return !less_xy(p, std::min(a, b, less_xy)) && !less_xy(std::max(a, b, less_xy), p);
}

/// True when the closed segments ab and cd share a point.
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(c, a, b)) || (abd == 0 && is_between(d, a, b)) ||
         (cda == 0 && is_between(a, c, d)) || (cdb == 0 && is_between(b, c, d));
}

/// True when the boundary turns back on itself at b.
bool is_spike(const Vec2& a, const Vec2& b, const Vec2& c) {
  return orientation(a, b, c) == 0 && !is_between(b, a, c);
}

bool is_simple(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n];
    if (a == b || is_spike(a, b, polygon[(i + 2) % n])) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      if (segments_meet(a, b, polygon[j], polygon[(j + 1) % n])) return false;
    }
  }
  return true;
}

/// Sense of rotation of a simple polygon: the turn at its leftmost corner, which is convex.
int rotation(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  const auto left =
      static_cast<std::size_t>(std::ranges::min_element(polygon, less_xy) - polygon.begin());
  return orientation(polygon[(left + n - 1) % n], polygon[left], polygon[(left + 1) % n]);
}

/// What is left of a counter-clockwise polygon, with the squared length of the diagonal at every
/// corner that is an ear.
class Clipper {
 public:
  Clipper(std::span<const Vec2> polygon, std::vector<int> corners)
      : polygon_(polygon), corners_(std::move(corners)), diagonal_(corners_.size()) {
    refresh_all();
  }

  std::vector<Piece> clip() {
    std::vector<Piece> pieces;
    while (corners_.size() > 3) {
      auto ear = std::ranges::min_element(diagonal_);
      if (*ear == kNoEar) {  // the corners that were in the way are gone by now
        refresh_all();
        ear = std::ranges::min_element(diagonal_);
      }
      pieces.push_back(cut(static_cast<std::size_t>(ear - diagonal_.begin())));
    }
    pieces.push_back({corners_[0], corners_[1], corners_[2]});
    return pieces;
  }

 private:
  static constexpr double kNoEar = std::numeric_limits<double>::infinity();

  std::size_t before(std::size_t i) const { return (i + corners_.size() - 1) % corners_.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % corners_.size(); }
  const Vec2& at(std::size_t i) const { return polygon_[static_cast<std::size_t>(corners_[i])]; }

  /// An ear: its triangle is positive and holds no other corner, not even on its border.
  bool is_ear(std::size_t i) const {
    const Vec2 &a = at(before(i)), &b = at(i), &c = at(after(i));
    if (orientation(a, b, c) <= 0) return false;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      if (k == before(i) || k == i || k == after(i)) continue;
      const Vec2& p = at(k);
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0)
        return false;
    }
    return true;
  }

  void refresh(std::size_t i) {
    // Capped so that an ear never looks like none when the square overflows.
    const double length = (at(before(i)) - at(after(i))).squaredNorm();
    diagonal_[i] = is_ear(i) ? std::min(length, std::numeric_limits<double>::max()) : kNoEar;
  }

  void refresh_all() {
    for (std::size_t i = 0; i < corners_.size(); ++i) refresh(i);
  }

  Piece cut(std::size_t i) {
    const Piece piece{corners_[before(i)], corners_[i], corners_[after(i)]};
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i));
    diagonal_.erase(diagonal_.begin() + static_cast<std::ptrdiff_t>(i));
    refresh(before(i));
    refresh(i % corners_.size());
    return piece;
  }

  std::span<const Vec2> polygon_;
  std::vector<int> corners_;
  std::vector<double> diagonal_;
};

}  // namespace

std::optional<std::vector<Piece>> clip_ears(std::span<const Vec2> polygon) {
  if (polygon.size() < 3 || polygon.size() > kMaxPolygonCorners || !is_simple(polygon))
    return std::nullopt;
  std::vector<int> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0);
  const bool clockwise = rotation(polygon) < 0;
  if (clockwise) std::ranges::reverse(corners);
  std::vector<Piece> pieces = Clipper(polygon, std::move(corners)).clip();
  if (clockwise)
    for (Piece& piece : pieces) std::swap(piece[1], piece[2]);
  return pieces;
}

}  // namespace foldless
