// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/goal.h"

#include <utility>

#include "core/energy/constraints.h"
#include "core/method/satisfied.h"

namespace foldless {

Goal::Goal(std::vector<Handle> handles, const Triangles& original, const Points& rest,
           double diagonal)
    : handles_(std::move(handles)), followers_(original, rest, handles_), diagonal_(diagonal) {}

void Goal::set_targets(const Points& targets, const std::vector<double>& angles) {
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    handles_[i].target = targets.col(static_cast<Eigen::Index>(i));
    if (handles_[i].turn && i < angles.size()) handles_[i].turn->angle = angles[i];
  }
}

bool Goal::is_met(const Points& u) const {
  return handle_error_squared(constraints_of(with_followers()), u) <=
         kSatisfied * diagonal_ * diagonal_;
}

}  // namespace foldless
