// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/pose_comparison.h"

#include <algorithm>
#include <utility>

#include "core/mesh/boundary.h"

namespace foldless {
PoseComparison::Outline PoseComparison::outline_of(const Snapshot& pose) {
  const auto neighbours =
      boundary_neighbours(*pose.triangles, static_cast<int>(pose.deformed.cols()));
  std::vector<bool> is_done(neighbours.size(), false);
  Outline outline;
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    if (is_done[v] || !neighbours[v].are_there()) continue;
    const std::vector<int> loop = boundary_loop(neighbours, static_cast<int>(v));
    for (const int corner : loop) is_done[static_cast<std::size_t>(corner)] = true;
    outline.push_back(pose.deformed(Eigen::all, loop));
  }
  return outline;
}

std::shared_ptr<const Snapshot> PoseComparison::kept() const {
  return kept_ && is_of_this_mesh(*kept_) ? kept_->shown : nullptr;
}

void PoseComparison::keep() {
  kept_ = Pose{draft_.document().original, draft_.shown()};
  messages_.toast(ToastKind::notice, "This pose is kept: hold \\ to see it in place of the newest");
}

std::vector<const PoseComparison::Outline*> PoseComparison::outlines() const {
  std::vector<const Outline*> result;
  for (const OutlineOfPose& entry : outlines_)
    if (is_of_this_mesh(entry.pose)) result.push_back(&entry.outline);
  return result;
}

void PoseComparison::toggle_outline() {
  std::erase_if(outlines_,
                [&](const OutlineOfPose& entry) { return !is_of_this_mesh(entry.pose); });
  const std::shared_ptr<const Snapshot>& shown = draft_.shown();
  const auto is_shown = [&](const OutlineOfPose& entry) {
    return entry.pose.shown->deformed.cols() == shown->deformed.cols() &&
           entry.pose.shown->deformed == shown->deformed;
  };
  if (std::erase_if(outlines_, is_shown) == 0)
    outlines_.push_back({{draft_.document().original, shown}, outline_of(*shown)});
  messages_.redraw();
}

}  // namespace foldless
