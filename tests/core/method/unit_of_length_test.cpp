// SPDX-License-Identifier: GPL-3.0-or-later
// Every constant of a method that is a length or an area is in units of D.
#include <gtest/gtest.h>

#include "core/method/methods.h"
#include "tests/core/method/method_fixture.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

Problem scaled(Problem problem, double scale) {
  const MeshPair& mesh = problem.mesh;
  problem.mesh = MeshPair(mesh.triangles(), scale * mesh.rest(), scale * mesh.deformed());
  for (Handle& handle : problem.handles) handle.target *= scale;
  return problem;
}

// A power of two scales without rounding, so that not a bit may differ.
TEST(UnitOfLength, IsOfNoConsequence) {
  for (const std::string_view name : {"foldless", "paper", "paper-flip", "lim"})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(testing::Message() << name << " seed " << seed);
      Problem problem = test::random_problem(seed);
      problem.parameters.inner_iterations = 60;
      const std::unique_ptr<Method> method = find_method(name)->start(problem);
      const std::unique_ptr<Method> larger = find_method(name)->start(scaled(problem, 16));
      for (int step = 0; step < 150; ++step) {
        const auto record = method->step({}), of_larger = larger->step({});
        ASSERT_EQ(record.has_value(), of_larger.has_value()) << "step " << step;
        if (!record) break;
        ASSERT_EQ(record->phase, of_larger->phase) << "step " << step;
        ASSERT_EQ(256 * record->energy, of_larger->energy) << "step " << step;
        ASSERT_EQ(16 * method->mesh().deformed(), larger->mesh().deformed()) << "step " << step;
      }
      EXPECT_EQ(method->outcome(), larger->outcome());
    }
}

}  // namespace
}  // namespace foldless
