// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/sample_animations.h"

#include <memory>
#include <vector>

#include "assets/make/place_handles.h"
#include "core/motion/animation.h"

namespace foldless::samples {
namespace {

const Easing kBoth = *find_easing("both");

/// A handle that goes away from its place at rest and back.
struct Step {
  int frame;
  Vec2 away;
};

void add_steps(Scene& scene, Animation& animation, const Vec2& place,
               const std::vector<Step>& steps) {
  const int v = nearest_vertex(scene, place);
  add_handle(scene, v, scene.rest.col(v));
  HandleTracks& tracks = animation.tracks.emplace_back();
  tracks.handle = scene.handles.back().id;
  tracks.is_smooth = true;
  for (const Step& step : steps)
    tracks.position.push_back({step.frame, Vec2(scene.rest.col(v)) + step.away, {}});
}

/// To a target and back, slow at both ends.
void add_stroke(Scene& scene, Animation& animation, const Vec2& place, const Vec2& target) {
  const int v = nearest_vertex(scene, place);
  add_handle(scene, v, scene.rest.col(v));
  HandleTracks& tracks = animation.tracks.emplace_back();
  tracks.handle = scene.handles.back().id;
  tracks.position = {{0, scene.rest.col(v), kBoth}, {animation.cycle.frames / 2, target, kBoth}};
}

void give(Scene& scene, Animation animation) {
  scene.parameters.method = "foldless";
  scene.animation = std::make_shared<const Animation>(std::move(animation));
}

}  // namespace

Scene walk(const SampleMesh& gingerbread) {
  Scene scene =
      scene_over(gingerbread, "arap", "A walk in 24 frames that never folds: see animate.");
  Animation animation;
  animation.cycle = {24, true};
  add_steps(scene, animation, {-1.02, 1.46}, {{0, {0.2, -0.55}}, {12, {-0.05, 0.3}}});
  add_steps(scene, animation, {1.02, 1.46}, {{0, {0.05, 0.3}}, {12, {-0.2, -0.55}}});
  add_steps(scene, animation, {-0.55, 0.22},
            {{0, {0.1, 0}},
             {3, {0.02, 0.22}},
             {6, {-0.12, 0.3}},
             {9, {-0.12, 0.1}},
             {12, {-0.1, 0}},
             {18, {0, 0}}});
  add_steps(scene, animation, {0.55, 0.22},
            {{0, {0.1, 0}},
             {6, {0, 0}},
             {12, {-0.1, 0}},
             {15, {-0.02, 0.22}},
             {18, {0.12, 0.3}},
             {21, {0.12, 0.1}}});
  add_steps(scene, animation, {0, 2.15},
            {{0, {0.08, -0.08}}, {6, {0.16, 0.08}}, {12, {-0.08, -0.08}}, {18, {-0.16, 0.08}}});
  give(scene, std::move(animation));
  return scene;
}

Scene snap(const SampleMesh& alligator) {
  Scene scene =
      scene_over(alligator, "green-strain",
                 "The alligator opens its jaws and snaps, 36 frames in a loop: see animate.");
  pin_at(scene, {{-0.75, 0.05}, {0.6, 0.05}});
  Animation animation;
  animation.cycle = {36, true};
  add_stroke(scene, animation, {2.5, 0.99}, {1.5, 2.3});
  add_stroke(scene, animation, {2.42, 0.45}, {2.6, 0.1});
  add_stroke(scene, animation, {-2.6, 0.58}, {-0.9, 1.9});
  give(scene, std::move(animation));
  return scene;
}

Scene turn_by_360(const SampleMesh& disk) {
  struct Turned {
    int frame;
    double degrees;
  };
  const std::vector<Turned> rim{{0, 0}, {12, 90}, {24, 180}, {36, 270}, {48, 360}};
  const std::vector<Turned> ring{{0, 0}, {16, 20}, {24, 180}, {32, 340}, {48, 360}};
  Scene scene = scene_over(
      disk, "arap", "The rim turns by 360 degrees; a ring inside lags and overtakes: see animate.");
  Animation animation;
  animation.cycle = {48, true};
  TurningGroup& group = animation.groups.emplace_back();
  const auto add = [&](int v, const std::vector<Turned>& keys) {
    add_handle(scene, v, scene.rest.col(v));
    HandleTracks& tracks = animation.tracks.emplace_back();
    tracks.handle = scene.handles.back().id;
    group.handles.push_back(tracks.handle);
    for (const auto& [frame, degrees] : keys)
      tracks.position.push_back({frame, turned(scene.rest.col(v), Vec2::Zero(), degrees), {}});
  };
  for (const int v : disk_ring(kCoarseDisk, 5)) add(v, ring);
  for (const int v : disk_ring(kCoarseDisk, kCoarseDisk.rings)) add(v, rim);
  give(scene, std::move(animation));
  return scene;
}

}  // namespace foldless::samples
