// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/patch_energy.h"

#include <cstddef>
#include <utility>

namespace foldless {
namespace {

std::size_t at_index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Energy energy_of(const Patch& patch, const Points& at, const std::vector<bool>& is_free,
                 const Energy& whole) {
  Energy energy = whole;
  energy.settings.gap_weight = 0;
  std::vector<Handle> handles;
  std::vector<int> place(is_free.size(), -1);
  for (int v = 0; v < std::ssize(patch.vertices); ++v) {
    const int in_whole = patch.vertices[at_index(v)];
    if (is_free[at_index(in_whole)])
      place[at_index(in_whole)] = v;
    else
      handles.push_back({.vertex = v, .target = at.col(in_whole)});
  }
  const Constraints& pulls = whole.constraints;
  for (int i = 0; i < pulls.count(); ++i)
    if (const int v = place[at_index(pulls.vertices[at_index(i)])]; v >= 0)
      handles.push_back({.vertex = v,
                         .target = pulls.targets.col(i),
                         .kind = HandleKind::soft,
                         .weight = pulls.weights[i]});
  energy.constraints = held(constraints_of(handles));
  return energy;
}

}  // namespace foldless
