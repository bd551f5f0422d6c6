// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/infeasible.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "core/construct/compatible_triangulation.h"
#include "core/construct/held_disk.h"
#include "core/mesh/winding.h"

namespace foldless {
namespace {

/// Some tenths of a second, which only regions with ten thousand corners could exceed.
constexpr std::size_t kMostEdgeTests = 50'000'000;

/// A region with the targets of its handles.
class Prescribed {
 public:
  Prescribed(const PrescribedRegion& region, const Constraints& constraints)
      : region_(region), constraints_(constraints) {
    for (const std::vector<int>& loop : region.loops) {
      polygons_.emplace_back(constraints.targets(Eigen::all, loop));
      corners_.insert(corners_.end(), loop.begin(), loop.end());
    }
    most_points_ = kMostEdgeTests / corners_.size();
  }

  std::optional<std::string> why_infeasible() const {
    for (const auto criterion :
         {&Prescribed::edge_of_no_length, &Prescribed::closed_gap, &Prescribed::negative_area,
          &Prescribed::wrong_turns, &Prescribed::crowded_target, &Prescribed::negative_winding,
          &Prescribed::no_disk})
      if (std::optional<std::string> why = (this->*criterion)()) return "infeasible: " + *why;
    return std::nullopt;
  }

 private:
  std::optional<std::string> edge_of_no_length() const {
    for (const std::vector<int>& loop : region_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        if (target(a) == target(b))
          return names({a, b}) + ", neighbours along the boundary, are to go to the same point";
      }
    return std::nullopt;
  }

  // The angle there is a multiple of 2π.
  std::optional<std::string> closed_gap() const {
    for (const std::vector<int>& loop : region_.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int v = loop[(i + 1) % loop.size()];
        if (goes_straight_back(target(loop[i]), target(v), target(loop[(i + 2) % loop.size()])))
          return the_boundary() + " is to go straight back at " + names({v});
      }
    return std::nullopt;
  }

  std::optional<std::string> negative_area() const {
    if (!is_area_negative(polygons_)) return std::nullopt;
    return the_boundary() + " is to go the wrong way round";
  }

  // Gauss–Bonnet: 2π χ is the sum over the boundary of π minus the angle of the map, which is that
  // of P, for both are more than nothing and less than 2π.
  std::optional<std::string> wrong_turns() const {
    int turns = 0;
    for (const Points& polygon : polygons_) turns += turning_number(polygon);
    if (turns == region_.euler_characteristic) return std::nullopt;
    return the_boundary() + " is to turn " + times(turns) + ", and must turn " +
           times(region_.euler_characteristic);
  }

  std::optional<std::string> no_disk() const {
    const bool is_disk = region_.euler_characteristic == 1 && polygons_.size() == 1;
    if (!is_disk || corners_.size() > static_cast<std::size_t>(kMostCornersOfADisk) ||
        bounds_disk(polygons_.front()))
      return std::nullopt;
    return the_boundary() + " is to cross itself so that it bounds no disk";
  }

  // Each of the vertices takes a neighbourhood of its own to one of the target.
  std::optional<std::string> crowded_target() const {
    std::vector<int> handles = region_.inside;
    std::ranges::sort(handles, {}, [&](int i) {
      const Vec2 p = target(i);
      return std::tuple(p.x(), p.y(), i);
    });
    std::size_t points = 0;
    for (std::size_t i = 0; i < handles.size() && points < most_points_; ++points) {
      std::size_t end = i + 1;
      while (end < handles.size() && target(handles[end]) == target(handles[i])) ++end;
      const int room = least_winding_beside(polygons_, target(handles[i]));
      if (room <= 0) return names({handles[i]}) + " is to go out of the held boundary, or onto it";
      const auto first = handles.begin() + static_cast<std::ptrdiff_t>(i);
      if (end - i > static_cast<std::size_t>(room))
        return names({first, first + room + 1}) +
               " are to go to the same point, which the held boundary goes round " + times(room);
      i = end;
    }
    return std::nullopt;
  }

  std::optional<std::string> negative_winding() const {
    for (const int corner : std::span(corners_).first(std::min(corners_.size(), most_points_)))
      if (least_winding_beside(polygons_, target(corner)) < 0)
        return the_boundary() + " is to go the wrong way round points beside " + names({corner});
    return std::nullopt;
  }

  Vec2 target(int handle) const { return constraints_.targets.col(handle); }

  std::string name(int handle) const {
    return std::to_string(constraints_.vertices[static_cast<std::size_t>(handle)]);
  }

  std::string names(const std::vector<int>& handles) const {
    std::string words = handles.size() == 1 ? "vertex " : "vertices ";
    for (std::size_t i = 0; i < handles.size(); ++i)
      words += (i == 0 ? "" : i + 1 < handles.size() ? ", " : " and ") + name(handles[i]);
    return words;
  }

  std::string the_boundary() const {
    return "the held boundary with vertex " + name(corners_.front());
  }

  static std::string times(int count) {
    return count == 1 ? "once" : std::to_string(count) + " times";
  }

  const PrescribedRegion& region_;
  const Constraints& constraints_;
  std::vector<Points> polygons_;  ///< P
  std::vector<int> corners_;      ///< handles, in the order of the loops
  std::size_t most_points_;       ///< that a criterion looks at
};

}  // namespace

std::optional<std::string> why_infeasible(const std::vector<PrescribedRegion>& regions,
                                          const Constraints& constraints) {
  for (const PrescribedRegion& region : regions)
    if (auto why = Prescribed(region, constraints).why_infeasible()) return why;
  return std::nullopt;
}

}  // namespace foldless
