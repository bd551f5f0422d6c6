// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/run/run.h"
#include "tests/core/method/method_fixture.h"
#include "tests/core/run/run_fixture.h"

namespace foldless::test {

struct NamedProblem {
  std::string name;
  Problem problem;
};

/// Scenes whose paths do not hang on the rounding of their coordinates.
inline std::vector<NamedProblem> calm_scenes() {
  return {{"pulled dirichlet", pulled_grid("dirichlet", Vec2(0.21, 0.13))},
          {"pulled lscm", pulled_grid("lscm", Vec2(0.11, -0.17))},
          {"squeezed arap", pulled_grid("arap", Vec2(-0.31, -0.22))},
          {"squeezed green-strain", pulled_grid("green-strain", Vec2(-0.2, -0.1))},
          {"sheared symmetric-dirichlet", pulled_grid("symmetric-dirichlet", Vec2(-0.17, 0.35))},
          {"turned disk", turned_disk({.ring = 4, .degrees = 70})}};
}

/// How a run ended, and what must not change of it: all but the distortion energy, which is
/// compared as a number.
struct End {
  std::string outcome;
  int factorizations = 0;
  int flips = 0;
  bool satisfied = false;
  double distortion_energy = 0;
  bool operator==(const End& other) const {
    return outcome == other.outcome && factorizations == other.factorizations &&
           flips == other.flips && satisfied == other.satisfied;
  }
};

inline std::ostream& operator<<(std::ostream& out, const End& end) {
  return out << end.outcome << ", H " << end.factorizations << ", " << end.flips << " flips, "
             << (end.satisfied ? "satisfied" : "not satisfied");
}

/// To 1e-6, in units of `scale` to one.
inline void expect_same_distortion(const End& found, const End& expected, double scale = 1) {
  const double E_d = scale * scale * expected.distortion_energy;
  EXPECT_NEAR(found.distortion_energy, E_d, 1e-6 * E_d);
}

/// How a method ends; "refused" where it does not take the energy.
inline End end_of(Problem problem, std::string_view method) {
  problem.parameters.method = method;
  try {
    foldless::Run run(problem);
    const std::vector<Iteration> records = finish(run, 20000);
    EXPECT_TRUE(run.outcome());
    const Iteration last = records.empty() ? Iteration() : records.back();
    return {std::string(name_of(run.outcome().value())), last.factorizations, last.flips,
            run.is_satisfied(), last.distortion_energy};
  } catch (const Error&) {
    return {.outcome = "refused"};
  }
}

}  // namespace foldless::test
