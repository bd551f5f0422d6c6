// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion_frames.h"

#include <algorithm>
#include <utility>

#include "core/run/mesh_at_rest.h"

namespace foldless {
namespace {

/// Without what the solver does not see, so that a change of it solves nothing anew.
AnimationToSolve animation_to_solve(const Document& document) {
  const Shape& original = *document.original;
  auto [mesh, handles] =
      mesh_at_rest(original, document.handles, *document.pose->rest, document.parameters.delta);
  mesh.set_stiffness(stiffness_with(document.stiffness, handles, mesh.rest()));
  for (Handle& handle : handles) {
    handle.name.clear();
    handle.depth = 0;
  }
  AnimationToSolve wanted;
  wanted.animation = *document.animation;
  for (HandleTracks& tracks : wanted.animation.tracks) tracks.depth.clear();
  wanted.at_rest = {std::move(mesh), document.energy, std::move(handles), document.parameters,
                    OriginalMesh{std::shared_ptr<const Triangles>(document.original,
                                                                  &document.original->triangles),
                                 static_cast<int>(original.rest.cols())}};
  wanted.tolerance = closing_tolerance(original.rest);
  return wanted;
}

}  // namespace

void MotionFrames::follow(const Document& document) {
  Source source{document.original,  document.stiffness, document.handles,
                document.animation, document.energy,    document.parameters};
  if (source == source_) return;
  source_ = std::move(source);
  if (document.is_empty() || !document.animation || document.animation->tracks.empty())
    frames_.clear();
  else
    frames_.solve(animation_to_solve(document));
}

std::shared_ptr<const SolvedFrame> MotionFrames::frame(int index) const {
  return frames_.frame(static_cast<std::size_t>(index));
}

std::shared_ptr<const Snapshot> MotionFrames::pose(const Document& document, int index) const {
  const auto solved = frame(index);
  if (!solved || !document.animation) return nullptr;
  const auto now = handles_at(*document.animation, document.handles, index);
  auto pose = std::make_shared<Snapshot>(*solved->snapshot);
  for (Handle& handle : pose->handles) {
    const auto same = std::ranges::find(now, handle.id, &Handle::id);
    if (same == now.end()) continue;
    handle.name = same->name;
    handle.depth = same->depth;
  }
  return pose;
}

}  // namespace foldless
