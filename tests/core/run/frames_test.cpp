// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/frames.h"

#include <gtest/gtest.h>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/motion/bake.h"

namespace foldless {
namespace {

/// A bar that is held at its left end; its right end swings up and back, in a loop.
class FramesOfABar : public testing::Test {
 protected:
  FramesOfABar() {
    const Shape shape = bar(4, 1, 4);
    problem_.mesh = MeshPair(shape.triangles, shape.rest);
    problem_.energy = find_density("arap");
    for (int v = 0; v < shape.rest.cols(); ++v) {
      const Vec2 p = shape.rest.col(v);
      if (p.x() == 0 || p.x() == 4) add_handle(v, p);
    }
  }

  void add_handle(int v, const Vec2& p) {
    Handle handle;
    handle.id = v;
    handle.vertex = v;
    handle.target = p;
    problem_.handles.push_back(handle);
    if (p.x() == 0) return;
    HandleTracks tracks;
    tracks.handle = v;
    tracks.position = {{0, p, *find_easing("both")}, {8, Vec2(2.5 - p.y(), 3), {}}};
    animation_.tracks.push_back(tracks);
    animation_.cycle = {16, true};
  }

  std::vector<SolvedFrame> all(const Frames& frames) const {
    std::vector<SolvedFrame> solved;
    for (int i = 0; i < frames.animation().cycle.frames; ++i)
      solved.push_back(
          *frames.solve(i, solved.empty() ? nullptr : solved.back().snapshot.get(), {}));
    return solved;
  }

  Problem problem_;
  Animation animation_;
};

bool is_same(const SolvedFrame& a, const SolvedFrame& b) {
  const Snapshot &s = *a.snapshot, &t = *b.snapshot;
  return s.triangles->cols() == t.triangles->cols() && *s.triangles == *t.triangles &&
         s.rest->cols() == t.rest->cols() && *s.rest == *t.rest && s.deformed == t.deformed;
}

TEST_F(FramesOfABar, AreInjectiveAndAtTheirTargets) {
  const std::vector<SolvedFrame> solved = all(Frames(problem_, animation_));
  for (const SolvedFrame& frame : solved) {
    EXPECT_TRUE(frame.is_satisfied) << frame.frame << ": " << frame.verdict;
    const Snapshot& s = *frame.snapshot;
    EXPECT_TRUE(is_injective(*s.triangles, *s.rest, s.deformed)) << frame.frame;
    for (const Handle& handle : handles_at(animation_, problem_.handles, frame.frame))
      EXPECT_LT((s.deformed.col(handle.vertex) - handle.target).norm(), 1e-4) << frame.frame;
  }
  EXPECT_EQ(solved[8].snapshot->handles.back().target, Vec2(1.5, 3));
}

TEST_F(FramesOfABar, AreTheSameWheneverTheyAreSolved) {
  const Frames frames(problem_, animation_);
  const std::vector<SolvedFrame> once = all(frames);
  const std::vector<SolvedFrame> again = all(Frames(problem_, animation_));
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_TRUE(is_same(once[i], again[i])) << i;
  const auto alone = frames.solve(9, once[8].snapshot.get(), {});
  ASSERT_TRUE(alone);
  EXPECT_TRUE(is_same(*alone, once[9])) << "from the frame before alone";
}

TEST_F(FramesOfABar, ThoseBeforeAKeyThatMovesStay) {
  Animation changed = animation_;
  changed.cycle.loops = animation_.cycle.loops = false;
  for (HandleTracks& tracks : changed.tracks)
    tracks.position.push_back({12, tracks.position.back().value + Vec2(0.25, 0), {}});
  const std::vector<SolvedFrame> before = all(Frames(problem_, animation_));
  const std::vector<SolvedFrame> after = all(Frames(problem_, changed));
  for (std::size_t i = 0; i <= 8; ++i) EXPECT_TRUE(is_same(before[i], after[i])) << i;
  for (std::size_t i = 9; i <= 12; ++i) EXPECT_FALSE(is_same(before[i], after[i])) << i;
}

TEST_F(FramesOfABar, TheLoopComesBackToItsFirstShape) {
  const Frames frames(problem_, animation_);
  const std::vector<SolvedFrame> solved = all(frames);
  const auto closing = frames.solve(16, solved.back().snapshot.get(), {});
  ASSERT_TRUE(closing);
  const int n = closing->snapshot->original_vertices;
  EXPECT_LT((closing->snapshot->deformed.leftCols(n) - solved[0].snapshot->deformed.leftCols(n))
                .cwiseAbs()
                .maxCoeff(),
            0.01);
}

TEST_F(FramesOfABar, AreBakedAndProvedAtEveryMoment) {
  const Frames frames(problem_, animation_);
  FramesToBake to_bake;
  to_bake.original = problem_.mesh.triangles();
  to_bake.cycle_frames = 16;
  to_bake.loops = true;
  for (const SolvedFrame& frame : all(frames)) {
    to_bake.moments.push_back(frame.frame);
    to_bake.snapshots.push_back(frame.snapshot);
  }
  const auto baked = bake(to_bake, {0.002, 16},
                          [&](double moment, const Snapshot& before) {
                            return frames.solve(moment, &before, {})->snapshot;
                          },
                          {});
  ASSERT_TRUE(baked);
  EXPECT_TRUE(failures_of(*baked).empty());
  EXPECT_LE(baked->deviation, 0.002);
  EXPECT_LE(baked->rest.cols(), 3 * problem_.mesh.vertex_count());
}

TEST_F(FramesOfABar, EndWhenTheyAreStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(Frames(problem_, animation_).solve(5, nullptr, stop.get_token()));
}

}  // namespace
}  // namespace foldless
