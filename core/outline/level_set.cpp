// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/level_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace foldless {
namespace {

/// Corners of loops keep this much of an edge's length from its ends, so that loops of neighbouring
/// squares cannot meet there.
constexpr double kClearance = 0.02;

/// The field in a frame one cell wide, in which it changes its sign halfway: at the grid's border.
ScalarGrid framed(const ScalarGrid& field) {
  ScalarGrid result(field.width + 2, field.height + 2);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const int inner_x = std::clamp(x - 1, 0, field.width - 1);
      const int inner_y = std::clamp(y - 1, 0, field.height - 1);
      const float value = field.at(inner_x, inner_y);
      const bool is_inner = inner_x == x - 1 && inner_y == y - 1;
      result.at(x, y) = is_inner ? value : -std::abs(value);
    }
  return result;
}

/// Follows the level set from edge to edge of the grid of centres. An edge is twice the number of
/// its left or upper centre, plus one when it goes down.
class Marcher {
 public:
  explicit Marcher(const ScalarGrid& field) : field_(field), next_(2 * field.values.size(), kNone) {
    for (int y = 0; y + 1 < field.height; ++y)
      for (int x = 0; x + 1 < field.width; ++x) add_square(x, y);
    add_grid_corners();
  }

  std::vector<Loop> loops() {
    std::vector<Loop> found;
    for (std::size_t edge = 0; edge < next_.size(); ++edge)
      if (next_[edge] != kNone) found.push_back(loop_from(edge));
    return found;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  bool is_inside(int x, int y) const { return field_.at(x, y) > 0; }
  std::size_t across(int x, int y) const { return 2 * field_.index(x, y); }
  std::size_t down(int x, int y) const { return across(x, y) + 1; }

  /// The square of four centres. Round it, clockwise on screen, the level set enters the square
  /// where the region begins and leaves it where the region ends.
  void add_square(int x, int y) {
    const std::array<bool, 4> inside{is_inside(x, y), is_inside(x + 1, y), is_inside(x + 1, y + 1),
                                     is_inside(x, y + 1)};
    const std::array<std::size_t, 4> sides{across(x, y), down(x + 1, y), across(x, y + 1),
                                           down(x, y)};
    const bool is_saddle =
        inside[0] == inside[2] && inside[1] == inside[3] && inside[0] != inside[1];
    const float sum =
        field_.at(x, y) + field_.at(x + 1, y) + field_.at(x + 1, y + 1) + field_.at(x, y + 1);
    // Round the two corners of the region apart, or round the two others.
    const std::size_t step = is_saddle && sum > 0 ? 3 : 1;
    for (std::size_t k = 0; k < 4; ++k) {
      if (inside[k] || !inside[(k + 1) % 4]) continue;
      std::size_t end = (k + step) % 4;
      while (!(inside[end] && !inside[(end + 1) % 4])) end = (end + 1) % 4;
      next_[sides[k]] = sides[end];
    }
  }

  /// A region that fills a corner of the grid has a corner there.
  void add_grid_corners() {
    const int right = field_.width - 2, bottom = field_.height - 2;
    if (is_inside(1, 1)) corner_after_[down(1, 0)] = {1, 1};
    if (is_inside(right, 1)) corner_after_[across(right, 1)] = {right + 1.0, 1};
    if (is_inside(1, bottom)) corner_after_[across(0, bottom)] = {1, bottom + 1.0};
    if (is_inside(right, bottom)) corner_after_[down(right, bottom)] = {right + 1.0, bottom + 1.0};
  }

  Loop loop_from(std::size_t start) {
    Loop loop;
    for (std::size_t edge = start; next_[edge] != kNone;) {
      loop.push_back(in_grid(crossing(edge)));
      if (const auto corner = corner_after_.find(edge); corner != corner_after_.end())
        loop.push_back(in_grid(corner->second));
      edge = std::exchange(next_[edge], kNone);
    }
    return loop;
  }

  /// In units where the centre of cell (x, y) of the framed field is (x + ½, y + ½), y down.
  Vec2 crossing(std::size_t edge) const {
    const auto width = static_cast<std::size_t>(field_.width);
    const int x = static_cast<int>(edge / 2 % width), y = static_cast<int>(edge / 2 / width);
    const bool goes_down = edge % 2 == 1;
    const double a = field_.at(x, y), b = goes_down ? field_.at(x, y + 1) : field_.at(x + 1, y);
    const double t = std::clamp(a / (a - b), kClearance, 1 - kClearance);
    return Vec2(x + 0.5, y + 0.5) + (goes_down ? Vec2(0, t) : Vec2(t, 0));
  }

  /// Without the frame, y up.
  Vec2 in_grid(const Vec2& framed) const {
    return {framed.x() - 1, field_.height - 1 - framed.y()};
  }

  const ScalarGrid& field_;
  std::vector<std::size_t> next_;  ///< by edge: the one to which the level set goes from it
  std::map<std::size_t, Vec2> corner_after_;
};

}  // namespace

std::vector<Loop> level_set(const ScalarGrid& field) {
  const ScalarGrid in_frame = framed(field);
  return Marcher(in_frame).loops();
}

}  // namespace foldless
