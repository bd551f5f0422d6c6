// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "tests/support/patience.h"

namespace foldless {
namespace {

bool are_equal(const SolvedFrame& a, const SolvedFrame& b) {
  const Snapshot &s = *a.snapshot, &t = *b.snapshot;
  return a.frame == b.frame && s.triangles->cols() == t.triangles->cols() &&
         *s.triangles == *t.triangles && *s.rest == *t.rest && s.deformed == t.deformed;
}

/// A bar that is held at its left end; its right end goes up, in 12 frames.
class Background : public testing::Test {
 protected:
  Background() {
    const Shape shape = bar(4, 1, 4);
    wanted_.at_rest.mesh = MeshPair(shape.triangles, shape.rest);
    wanted_.at_rest.energy = find_density("arap");
    for (int v = 0; v < shape.rest.cols(); ++v) {
      const Vec2 p = shape.rest.col(v);
      if (p.x() == 0 || p.x() == 4) add_handle(v, p);
    }
    wanted_.animation.cycle = {12, false};
    wanted_.tolerance = 1e-3;
  }

  void add_handle(int v, const Vec2& p) {
    Handle handle;
    handle.id = v;
    handle.vertex = v;
    handle.target = p;
    wanted_.at_rest.handles.push_back(handle);
    if (p.x() == 0) return;
    HandleTracks tracks;
    tracks.handle = v;
    tracks.position = {{0, p, {}}, {6, Vec2(3, p.y() + 2), {}}};
    wanted_.animation.tracks.push_back(tracks);
  }

  void wait() {
    const auto give_up = std::chrono::steady_clock::now() + test::kPatience;
    while (!frames_.status().is_done) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << frames_.status().solved;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  SolvedAnimation expected() const {
    const Frames frames(wanted_.at_rest, wanted_.animation);
    return *solve_animation(
        frames, {moments_of(wanted_.animation, wanted_.animation.fps), wanted_.tolerance}, {});
  }
  void expect_all_as_expected() {
    const SolvedAnimation solved = expected();
    ASSERT_EQ(frames_.status().solved, solved.frames.size());
    for (std::size_t i = 0; i < solved.frames.size(); ++i)
      EXPECT_TRUE(are_equal(*frames_.frame(i), solved.frames[i])) << i;
  }

  AnimationToSolve wanted_;
  BackgroundFrames frames_;
};

TEST_F(Background, GivesTheFramesOfTheWholeAnimation) {
  frames_.solve(wanted_);
  wait();
  expect_all_as_expected();
  EXPECT_EQ(frames_.frame(12), nullptr);
  EXPECT_FALSE(frames_.status().gap);
}

TEST_F(Background, GivesTheRoundOfALoopThatIsKept) {
  wanted_.animation.cycle.loops = true;
  wanted_.tolerance = 0;  // so that there is a second round
  frames_.solve(wanted_);
  wait();
  expect_all_as_expected();
  EXPECT_TRUE(frames_.status().gap);
}

TEST_F(Background, SayThatALoopIsGoneThroughOnceMore) {
  wanted_.animation.cycle.loops = true;
  wanted_.tolerance = 0;
  std::vector<int> rounds;
  const Frames frames(wanted_.at_rest, wanted_.animation);
  FramesWanted all{moments_of(wanted_.animation, wanted_.animation.fps), 0};
  all.progress = [&](std::size_t, std::size_t, int round) { rounds.push_back(round); };
  ASSERT_TRUE(solve_animation(frames, all, {}));
  EXPECT_EQ(std::ranges::count(rounds, 1), 12);
  EXPECT_EQ(std::ranges::count(rounds, 2), 12);
  std::atomic<int> latest = 1;
  BackgroundFrames* waking = nullptr;
  BackgroundFrames noted([&] { latest = std::max<int>(latest, waking->status().round); });
  waking = &noted;
  noted.solve(wanted_);
  const auto give_up = std::chrono::steady_clock::now() + test::kPatience;
  while (!noted.status().is_done && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(latest, 2);
  EXPECT_EQ(noted.status().round, 1) << "when it is done nothing goes on";
}

TEST_F(Background, SolvesNothingBeforeAKeyThatMoves) {
  frames_.solve(wanted_);
  wait();
  std::vector<std::shared_ptr<const SolvedFrame>> before;
  for (std::size_t i = 0; i < 12; ++i) before.push_back(frames_.frame(i));
  for (HandleTracks& tracks : wanted_.animation.tracks)
    tracks.position.push_back({10, tracks.position.back().value + Vec2(0, 0.5), {}});
  frames_.solve(wanted_);
  wait();
  expect_all_as_expected();
  for (std::size_t i = 0; i <= 6; ++i)
    EXPECT_EQ(frames_.frame(i)->snapshot, before[i]->snapshot) << "the same object, frame " << i;
  EXPECT_FALSE(are_equal(*frames_.frame(8), *before[8]));
}

TEST_F(Background, AChangeThatIsTakenBackSolvesNothingAnewInEitherRound) {
  wanted_.animation.cycle.loops = true;
  wanted_.tolerance = 0;  // so that there is a second round
  frames_.solve(wanted_);
  wait();
  const AnimationToSolve original = wanted_;
  std::vector<std::shared_ptr<const SolvedFrame>> before;
  for (std::size_t i = 0; i < 12; ++i) before.push_back(frames_.frame(i));
  for (HandleTracks& tracks : wanted_.animation.tracks) tracks.position.back().frame = 7;
  frames_.solve(wanted_);
  wait();
  expect_all_as_expected();
  EXPECT_FALSE(are_equal(*frames_.frame(6), *before[6]));
  frames_.solve(original);
  wait();
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(frames_.frame(i)->snapshot, before[i]->snapshot) << "the same object, frame " << i;
  wanted_ = original;
  expect_all_as_expected();
}

TEST_F(Background, AnotherProblemBeginsAnew) {
  frames_.solve(wanted_);
  wait();
  wanted_.at_rest.energy = find_density("symmetric-dirichlet");
  ASSERT_TRUE(wanted_.at_rest.energy);
  frames_.solve(wanted_);
  wait();
  expect_all_as_expected();
}

TEST_F(Background, RestsWhileItIsHeldAndGoesOnThen) {
  frames_.hold(true);
  frames_.solve(wanted_);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(frames_.status().solved, 0U);
  EXPECT_EQ(frames_.status().count, 12U);
  frames_.hold(false);
  while (frames_.status().solved < 2) std::this_thread::yield();
  frames_.hold(true);
  frames_.hold(false);
  wait();
  expect_all_as_expected();
}

TEST_F(Background, TellsWhatWentWrong) {
  wanted_.at_rest.parameters.method = "nobody's";
  frames_.solve(wanted_);
  const auto give_up = std::chrono::steady_clock::now() + test::kPatience;
  while (frames_.status().error.empty() && std::chrono::steady_clock::now() < give_up)
    std::this_thread::yield();
  EXPECT_NE(frames_.status().error.find("nobody's"), std::string::npos) << frames_.status().error;
  frames_.clear();
  EXPECT_EQ(frames_.status().count, 0U);
  EXPECT_TRUE(frames_.status().error.empty());
}

TEST_F(Background, SharesMeshesThatAreTheSameFromFrameToFrame) {
  frames_.solve(wanted_);
  wait();
  int shared = 0;
  for (std::size_t i = 1; i < 12; ++i)
    shared += frames_.frame(i)->snapshot->rest == frames_.frame(i - 1)->snapshot->rest ? 1 : 0;
  EXPECT_GT(shared, 6);
}

}  // namespace
}  // namespace foldless
