// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion_frames.h"

#include <algorithm>
#include <utility>

#include "core/run/mesh_at_rest.h"

namespace foldless {
namespace {

/// Without what the solver does not see, so that a change of it solves nothing anew.
AnimationToSolve without_looks(AnimationToSolve wanted) {
  for (Handle& handle : wanted.at_rest.handles) {
    handle.name.clear();
    handle.depth = 0;
  }
  for (HandleTracks& tracks : wanted.animation.tracks) tracks.depth.clear();
  return wanted;
}

}  // namespace

AnimationToSolve animation_to_solve(const Document& document) {
  const Shape& original = *document.original;
  auto [mesh, handles] =
      mesh_at_rest(original, document.handles, *document.pose->rest, document.parameters.delta);
  mesh.set_stiffness(stiffness_with(document.stiffness, handles, mesh.rest()));
  AnimationToSolve wanted;
  wanted.animation = *document.animation;
  wanted.at_rest = {std::move(mesh), document.energy, std::move(handles), document.parameters,
                    OriginalMesh{std::shared_ptr<const Triangles>(document.original,
                                                                  &document.original->triangles),
                                 static_cast<int>(original.rest.cols())}};
  wanted.tolerance = closing_tolerance(original.rest);
  return wanted;
}

std::shared_ptr<const Snapshot> pose_of(const Document& document, const SolvedFrame& solved) {
  const auto now = handles_at(*document.animation, document.handles, solved.frame);
  auto pose = std::make_shared<Snapshot>(*solved.snapshot);
  for (Handle& handle : pose->handles) {
    const auto same = std::ranges::find(now, handle.id, &Handle::id);
    if (same == now.end()) continue;
    handle.name = same->name;
    handle.depth = same->depth;
  }
  return pose;
}

void MotionFrames::follow(const Document& document) {
  Source source{document.original,  document.stiffness, document.handles,
                document.animation, document.energy,    document.parameters};
  if (source == source_) return;
  source_ = std::move(source);
  if (document.is_empty() || !document.animation || document.animation->tracks.empty())
    return clear();
  AnimationToSolve wanted = without_looks(animation_to_solve(document));
  solver_ = std::make_shared<const Frames>(wanted.at_rest, wanted.animation);
  frames_.solve(std::move(wanted));
}

void MotionFrames::clear() {
  solver_ = nullptr;
  frames_.clear();
}

std::shared_ptr<const SolvedFrame> MotionFrames::frame(int index) const {
  return frames_.frame(static_cast<std::size_t>(index));
}

std::shared_ptr<const SolvedFrame> MotionFrames::between(double moment) {
  const auto before = frame(static_cast<int>(moment));
  return before && solver_ ? moment_.at(moment, before, solver_) : nullptr;
}

std::vector<SolvedFrame> MotionFrames::solved() const {
  std::vector<SolvedFrame> frames;
  const FramesStatus progress = status();
  if (!progress.is_done) return frames;
  for (int index = 0; index < static_cast<int>(progress.count); ++index)
    frames.push_back(*frame(index));
  return frames;
}

std::vector<SolvedFrame> MotionFrames::all(const Document& document) const {
  std::vector<SolvedFrame> frames = solved();
  for (SolvedFrame& frame : frames) frame.snapshot = pose_of(document, frame);
  return frames;
}

}  // namespace foldless
