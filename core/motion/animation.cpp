// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/animation.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

Path path_of(const Animation& animation, const HandleTracks& tracks) {
  for (const TurningGroup& group : animation.groups)
    if (std::ranges::find(group.handles, tracks.handle) != group.handles.end())
      return {PathShape::swing, group.center};
  return {tracks.is_smooth ? PathShape::smooth : PathShape::straight, Vec2::Zero()};
}

void move(Handle& handle, const Animation& animation, const HandleTracks& tracks, double frame) {
  const Cycle& cycle = animation.cycle;
  if (!tracks.position.empty())
    handle.target = point_at(tracks.position, frame, cycle, path_of(animation, tracks));
  if (!tracks.angle.empty() && handle.turn)
    handle.turn->angle = value_at(tracks.angle, frame, cycle);
  if (!tracks.depth.empty()) handle.depth = value_at(tracks.depth, frame, cycle);
  if (!tracks.weight.empty()) handle.weight = value_at(tracks.weight, frame, cycle);
}

bool is_there(const std::vector<Handle>& handles, int id) {
  return std::ranges::find(handles, id, &Handle::id) != handles.end();
}

}  // namespace

std::vector<Handle> handles_at(const Animation& animation, std::vector<Handle> handles,
                               double frame) {
  for (const HandleTracks& tracks : animation.tracks) {
    const auto handle = std::ranges::find(handles, tracks.handle, &Handle::id);
    if (handle != handles.end()) move(*handle, animation, tracks, frame);
  }
  return handles;
}

Animation animation_of(Animation animation, const std::vector<Handle>& handles) {
  std::erase_if(animation.tracks,
                [&](const HandleTracks& tracks) { return !is_there(handles, tracks.handle); });
  for (TurningGroup& group : animation.groups)
    std::erase_if(group.handles, [&](int id) { return !is_there(handles, id); });
  std::erase_if(animation.groups, [](const TurningGroup& group) { return group.handles.empty(); });
  return animation;
}

}  // namespace foldless
