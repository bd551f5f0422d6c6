// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/common_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/components.h"
#include "core/mesh/injective.h"
#include "core/method/similarity.h"

namespace foldless {
namespace common_motion {

/// What is left of the way where the handles move by one similarity, but for rounding.
constexpr double kExact = 1e-9;
constexpr double kLargestScale = 2;
/// A rigid motion is worth its while where less than this part of the way is left,
constexpr double kNear = 0.5;
/// and a handle has as far to go. [D]
constexpr double kLongWay = 0.05;

Similarity rigid(Similarity motion) {
  motion.a /= std::abs(motion.a);
  return motion;
}

std::optional<Similarity> motion_of(const Points& starts, const Points& targets, CommonMotion which,
                                    double diagonal) {
  const Points ways = targets - starts;
  const double way = ways.norm();
  if (way == 0) return std::nullopt;
  const Similarity similarity = similarity_of(starts, targets);
  if (which == CommonMotion::exact) {
    const double scale = std::abs(similarity.a);
    const bool is_exact = left_of_way(similarity, starts, targets) <= kExact * way &&
                          std::max(scale, 1 / scale) <= kLargestScale;
    return is_exact ? std::optional(similarity) : std::nullopt;
  }
  const Similarity motion = rigid(similarity);
  const bool is_long = ways.colwise().norm().maxCoeff() >= kLongWay * diagonal;
  return is_long && left_of_way(motion, starts, targets) < kNear * way ? std::optional(motion)
                                                                       : std::nullopt;
}

int vertex_of(const Constraints& constraints, int handle) {
  return constraints.vertices[static_cast<std::size_t>(handle)];
}

/// The vertices of the components of the handles of `work.parts`, moved with those; nothing where
/// no part has such a motion.
std::optional<Points> moved_together(const Workspace& work, CommonMotion which) {
  const Constraints& constraints = work.constraints;
  const Points starts = work.handles();
  Points u = work.mesh.deformed();
  bool has_moved = false;
  std::vector<int> components;
  for (const std::vector<int>& part : work.parts) {
    const auto motion = motion_of(starts(Eigen::all, part), constraints.targets(Eigen::all, part),
                                  which, work.settings->diagonal);
    if (!motion) continue;
    if (!has_moved) components = components_of(work.mesh.triangles(), work.mesh.vertex_count());
    has_moved = true;
    const auto component_of = [&](int v) { return components[static_cast<std::size_t>(v)]; };
    const int moving = component_of(vertex_of(constraints, part.front()));
    for (int v = 0; v < work.mesh.vertex_count(); ++v)
      if (component_of(v) == moving) u.col(v) = (*motion)(u.col(v));
    if (which == CommonMotion::near) continue;
    for (const int h : part)
      if (!constraints.soft[static_cast<std::size_t>(h)])
        u.col(vertex_of(constraints, h)) = constraints.targets.col(h);
  }
  return has_moved ? std::optional(std::move(u)) : std::nullopt;
}

bool is_allowed(const Workspace& work, const Points& u) {
  return work.system.objective().is_feasible(work.settings->energy, work.mesh.deformed(), u) &&
         is_injective(work.mesh.triangles(), u);
}

}  // namespace common_motion

Steps<bool> move_together(Workspace& work, CommonMotion which) {
  using namespace common_motion;
  std::optional<Points> moved = moved_together(work, which);
  if (!moved || !is_allowed(work, *moved)) co_return false;
  const auto move = [&](const std::stop_token&) {
    const double largest = (*moved - work.mesh.deformed()).lpNorm<Eigen::Infinity>();
    work.mesh.set_deformed(*std::move(moved));
    work.system.factor().outdate();
    return VertexUpdate{.step_length = 1, .step_infinity_norm = largest};
  };
  const VertexUpdate update = co_await vertex_update(move);
  co_yield work.record(update, work.held_energy(), Phase::pursue);
  co_return true;
}

}  // namespace foldless
