// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/paced_run.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"

namespace foldless {
namespace {

/// Its first steps are of one phase, what follows of another.
class TwoPhases final : public Method {
 public:
  TwoPhases(const Problem& problem, Phase first, Phase then)
      : mesh_(problem.mesh), first_(first), then_(then) {}

  std::optional<Iteration> step(const std::stop_token&) override {
    Iteration iteration;
    iteration.phase = ++steps_ <= 2 ? first_ : then_;
    return iteration;
  }
  std::optional<Outcome> outcome() const override { return std::nullopt; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points&) override {}

 private:
  MeshPair mesh_;
  Phase first_, then_;
  int steps_ = 0;
};

PacedRun run_of(Phase first, Phase then) {
  PacedRun run(
      [=](const Problem& problem) { return std::make_unique<TwoPhases>(problem, first, then); });
  const Shape shape = grid({.columns = 2, .rows = 2});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  problem.handles.push_back({.id = 1, .vertex = 0, .target = shape.rest.col(0)});
  Inbox messages;
  messages.load = std::make_unique<const Inbox::Load>(Inbox::Load{std::move(problem), 1});
  messages.set_mode(WorkerMode::running);
  run.apply(messages);
  return run;
}

TEST(PacedRun, StepsOfAWalkWaitForThePictureBeforeThem) {
  PacedRun run = run_of(Phase::walk, Phase::settle);
  EXPECT_FALSE(run.next_start()) << "nothing was shown yet";
  const auto before = PacedRun::Clock::now();
  run.iterate({});
  ASSERT_TRUE(run.next_start());
  EXPECT_GE(*run.next_start() - before, std::chrono::milliseconds(16));
  run.iterate({});
  run.iterate({});
  EXPECT_FALSE(run.next_start()) << "the walk is over";
}

TEST(PacedRun, OtherStepsDoNotWait) {
  PacedRun run = run_of(Phase::settle, Phase::settle);
  run.iterate({});
  EXPECT_FALSE(run.next_start());
}

TEST(PacedRun, ASlowerPaceHoldsForAWalkToo) {
  PacedRun run = run_of(Phase::walk, Phase::walk);
  Inbox messages;
  messages.pace = 2.0;
  run.apply(messages);
  const auto before = PacedRun::Clock::now();
  run.iterate({});
  ASSERT_TRUE(run.next_start());
  EXPECT_GE(*run.next_start() - before, std::chrono::milliseconds(500));
}

}  // namespace
}  // namespace foldless
