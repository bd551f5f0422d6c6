// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Where a polygon goes straight back its angle is none, or a full turn round the tip of a slit.
enum class StraightBack { none, full_turn };

/// What every corner of a closed polygon, which may cross and overlap itself, sees of the others
/// inside of its angle there: that from the way to the next corner, counter-clockwise, to the way
/// to the previous one, more than none and less than a full turn but at tips of slits. Exact. O(n²
/// log n).
class CornerOrder {
 public:
  /// Corners are columns, three or more, the last is joined to the first.
  explicit CornerOrder(const Points& polygon, StraightBack tips = StraightBack::none);

  int corners() const { return static_cast<int>(polygon_.cols()); }
  /// Whether the corners i < j < k make a piece of a triangulation of the polygon [SV92]: a
  /// counter-clockwise triangle whose sides, where they are not sides of the polygon, leave each
  /// corner inside of its angle, and in an order that leaves room for what is cut off by them. The
  /// angles of pieces with common sides that fill the polygon then add up to those of the polygon.
  bool is_piece(int i, int j, int k) const;

 private:
  /// The place of the way from v to w among those from v, counter-clockwise from that to the next
  /// corner, 0; equal for equal directions; −1 for one that is not inside of the angle.
  int place(int v, int w) const { return places_(w, v); }
  void sort_round(int v, StraightBack tips);

  Points polygon_;
  Eigen::MatrixXi places_;  ///< n × n
};

}  // namespace foldless
