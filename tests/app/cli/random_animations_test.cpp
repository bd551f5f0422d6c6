// SPDX-License-Identifier: GPL-3.0-or-later
// Hard motions: the handles of scenes of the random suite go straight from rest to their targets,
// as in scripts/tables/animations.py.
#include <gtest/gtest.h>

#include "app/bench/random_suite.h"
#include "app/cli/problem.h"
#include "core/run/frames_box.h"
#include "core/run/solved_animation.h"
#include "core/run/solved_bake.h"
#include "core/scene/failure_words.h"

namespace foldless {
namespace {

constexpr int kFrames = 24;
constexpr double kTolerance = 0.5;  ///< [pixels]

/// A scene's handles on their way.
Animation way_to_targets(const Scene& scene) {
  Animation animation;
  animation.fps = kFrames;
  animation.cycle = {kFrames, false};
  for (const Handle& handle : scene.handles) {
    HandleTracks tracks;
    tracks.handle = handle.id;
    tracks.position = {{0, scene.rest.col(handle.vertex), {}}, {kFrames - 1, handle.target, {}}};
    animation.tracks.push_back(tracks);
  }
  return animation;
}

TEST(RandomAnimations, AreProvedOrTheMomentIsNamedWithinHalfAPixelAndThriceTheVertices) {
  int proved = 0;
  constexpr int kScenes = 4;
  for (int i = 0; i < kScenes; ++i) {
    const Scene scene = random_scene(7, i).scene;
    const Frames frames(problem_at_rest(scene), way_to_targets(scene));
    auto solved = solve_animation(frames, {moments_of(frames.animation(), kFrames)}, {});
    ASSERT_TRUE(solved) << i;
    const double pixel = length_of_a_pixel(box_round(solved->frames), std::nullopt);
    const auto baked = bake_solved(
        frames, {scene.triangles, std::move(solved->frames), false, kTolerance * pixel}, {});
    ASSERT_TRUE(baked) << i;
    EXPECT_LE(baked->deviation, kTolerance * pixel) << i;
    EXPECT_LE(baked->rest.cols(), 3 * scene.rest.cols()) << i;
    const std::vector<BakedFailure> failures = failures_of(*baked);
    proved += failures.empty() ? 1 : 0;
    for (const BakedFailure& failure : failures)
      EXPECT_NE(words_of(failure, *baked).find(" at frame "), std::string::npos);
  }
  EXPECT_GE(proved, kScenes - 1);
}

}  // namespace
}  // namespace foldless
