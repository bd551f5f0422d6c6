// SPDX-License-Identifier: GPL-3.0-or-later
// Every step of Lim against one that is put together from the paper's words.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/method/lim.h"
#include "core/method/remeshing_assisted.h"
#include "core/solve/newton_step.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

/// The step of [SKPSH13] from u with the shift μ: targets are those of the sub-step.
struct SubStep {
  SubStep(const Problem& problem, const Points& u, double mu)
      : energy{energy_settings(problem), constraints_of(problem.handles)},
        system(problem.mesh, energy.constraints, effort) {
    const double t = 1 / (1 + mu * mu);
    const Points handles = handle_positions(energy.constraints, u);
    energy.constraints.targets = t * energy.constraints.targets + (1 - t) * handles;
    system.assemble(energy, u);
    EXPECT_TRUE(factorize(system, mu));
    step = newton_step(system);
  }
  double energy_at(const Points& u) const { return system.objective().value(energy, u).total(); }

  Effort effort;
  Energy energy;
  NewtonSystem system;
  Points step;
};

TEST(LimSteps, AreThoseOfSubSteppingWithAScaleThatIsKeptHalvedOrDoubled) {
  int shifted = 0, halved = 0, doubled = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = test::random_problem(seed);
    Lim method(problem);
    double scale = 1;
    for (int k = 0; k < 25; ++k) {
      const Points u = method.mesh().deformed();
      const auto record = method.step({});
      if (!record || record->step_length == 0) break;
      SCOPED_TRACE(testing::Message() << "step " << k);
      const SubStep expected(problem, u, record->mu);
      const double t = record->step_length;
      const double size = expected.step.cwiseAbs().maxCoeff();
      ASSERT_LE((method.mesh().deformed() - u - t * expected.step).cwiseAbs().maxCoeff(),
                1e-7 * t * size);
      const bool was_first_trial = scale == t;
      for (; scale > t; scale /= 2, ++halved)
        ASSERT_FALSE(expected.energy_at(u + scale * expected.step) < expected.energy_at(u))
            << "a longer step would have done";
      ASSERT_EQ(scale, t);
      doubled += was_first_trial && t < 1;
      if (was_first_trial) scale = std::min(1.0, 2 * t);
      shifted += record->mu > 0;
    }
  }
  EXPECT_GT(shifted, 50) << "the claims would be empty";
  EXPECT_GT(halved, 50);
  EXPECT_GT(doubled, 20);
}

}  // namespace
}  // namespace foldless
