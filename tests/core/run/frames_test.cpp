// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/mesh/injective.h"
#include "core/motion/bake.h"
#include "tests/support/turn_along.h"

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
  const auto baked = bake(to_bake, {0.002, 16}, [](std::size_t) { return std::nullopt; }, {});
  ASSERT_TRUE(baked);
  EXPECT_TRUE(failures_of(*baked).empty());
  EXPECT_LE(baked->deviation, 0.002);
  EXPECT_LE(baked->rest.cols(), 3 * problem_.mesh.vertex_count());
}

TEST_F(FramesOfABar, StatesOnTheWayEndWithTheFrame) {
  const Frames frames(problem_, animation_);
  std::vector<std::shared_ptr<const Snapshot>> states;
  const auto frame =
      frames.solve(5, nullptr, {}, [&](const auto& state) { states.push_back(state); });
  ASSERT_TRUE(frame);
  ASSERT_FALSE(states.empty());
  EXPECT_EQ(states.back(), frame->snapshot);
  for (const auto& state : states)
    EXPECT_TRUE(is_injective(*state->triangles, *state->rest, state->deformed));
}

double turn_of(const Snapshot& map, const Vec2& from, const Vec2& to) {
  return test::turn_along({*map.triangles, *map.rest, map.deformed}, from, to);
}

TEST(FramesOfADisk, GoOnFromTheFrameBeforeThem) {
  // A ring is turned by 330° in eleven frames: from rest it would be turned back by 30°.
  const DiskOptions options{.rings = 6, .boundary_vertices = 24, .vertices = 103};
  const Shape shape = disk(options);
  Problem problem;
  problem.mesh = MeshPair(shape.triangles, shape.rest);
  problem.energy = find_density("arap");
  Animation animation;
  animation.cycle = {13, false};
  animation.groups.emplace_back();
  for (const int ring : {3, 6})
    for (const int v : disk_ring(options, ring)) {
      Handle handle;
      handle.id = handle.vertex = v;
      handle.target = shape.rest.col(v);
      problem.handles.push_back(handle);
      if (ring == 6) continue;
      HandleTracks& tracks = animation.tracks.emplace_back();
      tracks.handle = v;
      animation.groups[0].handles.push_back(v);
      const Vec2 p = handle.target;
      tracks.position = {
          {0, p, {}}, {3, {-p.y(), p.x()}, {}}, {6, -p, {}}, {9, {p.y(), -p.x()}, {}}, {12, p, {}}};
    }
  const Frames frames(problem, animation);
  std::shared_ptr<const Snapshot> before;
  for (int i = 0; i < 12; ++i) {
    const auto frame = frames.solve(i, before.get(), {});
    ASSERT_TRUE(frame && frame->is_satisfied) << i;
    before = frame->snapshot;
  }
  const auto alone = frames.solve(11, nullptr, {});
  const Vec2 inner = shape.rest.col(disk_ring(options, 3).front());
  const Vec2 outer = inner.normalized() * (1 - 1e-3) * shape.rest.colwise().norm().maxCoeff();
  constexpr double kThirtyDegrees = std::numbers::pi / 6;
  EXPECT_NEAR(turn_of(*before, inner, outer), -11 * kThirtyDegrees, 0.3);
  EXPECT_NEAR(turn_of(*alone->snapshot, inner, outer), kThirtyDegrees, 0.3);
}

TEST_F(FramesOfABar, EndWhenTheyAreStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(Frames(problem_, animation_).solve(5, nullptr, stop.get_token()));
}

}  // namespace
}  // namespace foldless
