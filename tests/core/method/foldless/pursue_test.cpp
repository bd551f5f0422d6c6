// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/pursue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/method/foldless/foldless.h"
#include "tests/support/random_scene.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

constexpr int kMostPursuitSteps = 400;

using test::is_valid;

/// A random scene at rest under `foldless`, whose handles a hand drags about.
struct Hand {
  explicit Hand(std::uint64_t seed) : random(seed), problem(test::random_problem(seed)) {
    targets.resize(2, static_cast<Eigen::Index>(problem.handles.size()));
    for (std::size_t i = 0; i < problem.handles.size(); ++i) {
      Handle& one = problem.handles[i];
      one.target = problem.mesh.rest().col(one.vertex);
      targets.col(static_cast<Eigen::Index>(i)) = one.target;
    }
    method = std::make_unique<Foldless>(problem);
  }

  /// One handle goes on by `stride` in a direction that bends, and now and then turns back.
  void move(double stride) {
    std::uniform_real_distribution<double> bend(-0.4, 0.4);
    heading += random() % 12 == 0 ? 3.0 : bend(random);
    if (random() % 20 == 0) handle = static_cast<Eigen::Index>(random() % problem.handles.size());
    targets.col(handle) += stride * Vec2(std::cos(heading), std::sin(heading));
    method->set_targets(targets);
  }
  double distance() const {
    double farthest = 0;
    for (std::size_t i = 0; i < problem.handles.size(); ++i) {
      const Vec2 p = method->mesh().deformed().col(problem.handles[i].vertex);
      farthest = std::max(farthest, (p - targets.col(static_cast<Eigen::Index>(i))).norm());
    }
    return farthest;
  }

  std::mt19937_64 random;
  Problem problem;
  Points targets;
  std::unique_ptr<Foldless> method;
  double heading = 0;
  Eigen::Index handle = 0;
};

// One or two handles move by a similarity, which costs none.
TEST(Pursue, AHandleThatMovesALittleIsExactlyHomeAfterOneFactorizationAtMost) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Hand hand(seed);
    hand.move(1e-3);
    const auto iteration = hand.method->step({});
    ASSERT_TRUE(iteration.has_value());
    EXPECT_EQ(iteration->phase, Phase::pursue);
    EXPECT_EQ(iteration->factorizations, hand.problem.handles.size() > 2 ? 1 : 0);
    EXPECT_EQ(hand.distance(), 0);
  }
}

TEST(Pursue, TargetsThatStayWhereTheyAreAreNotPursued) {
  Hand hand(3);
  hand.method->set_targets(hand.targets);
  EXPECT_NE(hand.method->step({})->phase, Phase::pursue);
}

TEST(Pursue, ADragThatNeverRestsEndsAtTheSameEnergyAsOneThatDoes) {
  Hand hasty(7), patient(7);
  double hasty_energy = 0, patient_energy = 0;
  for (int frame = 0; frame < 15; ++frame) {
    hasty.move(0.005);
    patient.move(0.005);
    ASSERT_TRUE(hasty.method->step({}).has_value());
    while (const auto iteration = patient.method->step({})) patient_energy = iteration->energy;
  }
  ASSERT_EQ(hasty.distance(), 0);
  while (const auto iteration = hasty.method->step({})) hasty_energy = iteration->energy;
  ASSERT_EQ(hasty.targets, patient.targets);
  EXPECT_NEAR(hasty_energy, patient_energy, 0.05 * patient_energy);
}

/// A bar with its left end held and the corners of its right end bent upwards, under ARAP.
Problem bar_bent_upwards() {
  const Shape shape = bar(4, 1, 10);
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  for (int v = 0; v < shape.rest.cols(); ++v) {
    const Vec2 p = shape.rest.col(v);
    const bool is_corner = p.x() == 4 && (p.y() == 0 || p.y() == 1);
    if (p.x() != 0 && !is_corner) continue;
    Handle handle;
    handle.id = handle.vertex = v;
    handle.target = is_corner ? Vec2(1.5 - 0.87 * (p.y() - 0.5), 1.5 + 0.5 * (p.y() - 0.5)) : p;
    problem.handles.push_back(handle);
  }
  return problem;
}

// With all of the barriers in its first step a drag would begin with a jerk.
TEST(Pursue, ADragThatBeginsAtRestBeginsWithTheShapeThatIsThere) {
  const Problem problem = bar_bent_upwards();
  Foldless method(problem);
  while (method.step({})) {
  }
  ASSERT_EQ(method.outcome(), Outcome::gradient);
  const Points rest = method.mesh().deformed();
  Points targets(2, static_cast<Eigen::Index>(problem.handles.size()));
  for (std::size_t i = 0; i < problem.handles.size(); ++i)
    targets.col(static_cast<Eigen::Index>(i)) = problem.handles[i].target;
  targets(0, 0) += 1e-9;
  method.set_targets(targets);
  ASSERT_EQ(method.step({})->phase, Phase::pursue);
  const double moved = (method.mesh().deformed() - rest).colwise().norm().maxCoeff();
  EXPECT_LT(moved, 0.04) << "one percent of D";
}

TEST(Pursue, IsValidOnRandomDragsWhateverIsCancelledAndExactlyHomeWhenItSaysSo) {
  std::set<Phase> phases;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Hand hand(seed);
    std::stop_source stopped;
    stopped.request_stop();
    for (int frame = 0; frame < 40; ++frame) {
      hand.move(seed % 5 == 0 ? 0.3 : seed % 3 == 0 ? 0.04 : 0.01);
      for (auto left = hand.random() % 4; left > 0; --left) {
        if (hand.random() % 3 == 0) {
          const Points before = hand.method->mesh().deformed();
          EXPECT_FALSE(hand.method->step(stopped.get_token()).has_value());
          EXPECT_EQ(hand.method->mesh().deformed(), before);
        }
        const auto iteration = hand.method->step({});
        ASSERT_TRUE(is_valid(hand.method->mesh())) << "frame " << frame;
        if (!iteration) break;
        phases.insert(iteration->phase);
        if (iteration->phase == Phase::settle) {
          EXPECT_EQ(hand.distance(), 0) << "frame " << frame;
        }
      }
    }
    for (int step = 0; step < kMostPursuitSteps; ++step) {
      const auto iteration = hand.method->step({});
      if (!iteration) break;
      phases.insert(iteration->phase);
      ASSERT_TRUE(is_valid(hand.method->mesh())) << "at rest, step " << step;
    }
    if (hand.method->outcome() == Outcome::gradient) {
      EXPECT_EQ(hand.distance(), 0);
    }
  }
  // The claim would be empty if nothing were ever in the way.
  EXPECT_TRUE(phases.contains(Phase::pursue) && phases.contains(Phase::settle));
  EXPECT_TRUE(phases.contains(Phase::approach));
}

}  // namespace
}  // namespace foldless
