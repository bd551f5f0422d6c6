// SPDX-License-Identifier: GPL-3.0-or-later
// What the records of a run say: the mesh on show, and totals that never go back.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/mesh/quality.h"
#include "core/method/methods.h"
#include "core/method/remeshing_assisted.h"
#include "tests/core/method/foldless/foldless_scenes.h"
#include "tests/core/method/method_fixture.h"

namespace foldless {
namespace {

void expect_record_of(const Iteration& record, const Method& method, const Problem& problem) {
  const MeshPair& mesh = method.mesh();
  const Quality quality = quality_of(mesh.triangles(), mesh.rest(), mesh.deformed());
  EXPECT_EQ(record.max_conformal_distortion, quality.max_conformal_distortion);
  EXPECT_EQ(record.mean_conformal_distortion, quality.mean_conformal_distortion);
  EXPECT_EQ(record.min_area_ratio, quality.min_area_ratio);
  EXPECT_EQ(record.handle_error_squared,
            handle_error_squared(constraints_of(problem.handles), mesh.deformed()));
}

TEST(Records, TheLastOneIsOfTheMeshThatARunEndsWith) {
  int locked = 0;
  for (const std::string_view name : {"paper", "paper-flip", "lim"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      SCOPED_TRACE(testing::Message() << name << " seed " << seed);
      Problem problem = test::trading_places(seed);
      problem.parameters.inner_iterations = 30;
      if (seed % 2 == 0) problem.parameters.alpha = 1;  // rounds of splits may be undone
      const std::unique_ptr<Method> method = find_method(name)->start(problem);
      const Iteration last = test::run_to_its_end(*method);
      expect_record_of(last, *method, problem);
      locked += name == "paper" && !test::is_satisfied(*method, last);
    }
  EXPECT_GE(locked, 3) << "rounds of splits that gained nothing were to be undone";
}

}  // namespace
}  // namespace foldless
