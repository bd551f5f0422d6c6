// SPDX-License-Identifier: GPL-3.0-or-later
#include <foldless/check.h>
#include <foldless/energy.h>
#include <foldless/solve.h>
#include <foldless/version.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/core/api/api_fixture.h"

namespace foldless {
namespace {

using test::farthest;
using test::solved;
using test::Task;
using test::words_of_error;

PointMatrix at_handles(const Result& result, const Task& task) {
  PointMatrix places(static_cast<Eigen::Index>(task.handles.size()), 2);
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    places.row(i) =
        result.deformed.row(result.parents.outputs[task.handles[static_cast<std::size_t>(i)]]);
  return places;
}

TEST(Solve, BringsHandlesToTheirTargetsWithoutAFold) {
  const Task task = test::swapped_square(12);
  const Result result = solved(task);
  EXPECT_TRUE(result.is_reached);
  EXPECT_EQ(result.outcome, Outcome::gradient);
  EXPECT_LT(farthest(at_handles(result, task), task.targets), 1e-5);
  EXPECT_TRUE(check(result.rest, result.triangles, result.deformed).is_injective());
  ASSERT_FALSE(result.log.empty());
  EXPECT_GT(result.log.back().flips, 0);
}

TEST(Solve, KeepsTheTrianglesOnRequestAndSaysThatItDoesNotArrive) {
  const Task task = test::swapped_square(12);
  SolveOptions options;
  options.fixed_triangulation = true;
  const Result result = solved(task, options);
  EXPECT_EQ(result.triangles, task.triangles);
  EXPECT_EQ(result.rest, task.rest);
  EXPECT_FALSE(result.is_reached);
  EXPECT_GT(farthest(at_handles(result, task), task.targets), 0.01);
  EXPECT_TRUE(check(result.rest, result.triangles, result.deformed).is_injective());
}

TEST(Solve, ArrivesWithTheTrianglesThatAreThereWhereThatIsPossible) {
  const Task task = test::pulled_square(8);
  SolveOptions options;
  options.fixed_triangulation = true;
  const Result result = solved(task, options);
  EXPECT_TRUE(result.is_reached);
  EXPECT_EQ(result.triangles, task.triangles);
}

TEST(Solve, StopsWhenItsTimeIsOver) {
  SolveOptions options;
  options.time_limit = 0.05;
  const Result result = solved(test::swapped_square(60), options);
  EXPECT_EQ(result.outcome, Outcome::time_limit);
  EXPECT_TRUE(check(result.rest, result.triangles, result.deformed).is_injective());
}

TEST(Solve, MinimisesTheEnergyThatItIsAskedFor) {
  const Task task = test::pulled_square(8);
  SolveOptions lscm;
  lscm.energy = "lscm";
  lscm.fixed_triangulation = true;
  SolveOptions arap = lscm;
  arap.energy = "arap";
  const Result of_lscm = solved(task, lscm), of_arap = solved(task, arap);
  const auto energy_of = [&](const Result& result, const char* name) {
    return distortion_energy(result.rest, result.triangles, result.deformed, name);
  };
  EXPECT_LT(energy_of(of_arap, "arap"), energy_of(of_lscm, "arap"));
  EXPECT_LT(energy_of(of_lscm, "lscm"), energy_of(of_arap, "lscm"));
  EXPECT_NEAR(of_arap.log.back().distortion_energy, energy_of(of_arap, "arap"), 1e-9);
}

TEST(Solve, SaysInOneSentenceWhatIsWrongWithItsInput) {
  const Task good = test::pulled_square(4);
  const auto words = [&](const auto& spoil) {
    Task task = good;
    SolveOptions options;
    spoil(task, options);
    return words_of_error([&] { solved(task, options); });
  };
  EXPECT_EQ(words([](Task& task, auto&) { task.triangles(3, 1) = 25; }),
            "triangle 3 names the vertex 25, but the vertices are 0 to 24");
  EXPECT_EQ(words([](Task& task, auto&) { task.triangles.resize(0, 3); }),
            "the mesh has no triangle; give at least one");
  EXPECT_EQ(words([](Task& task, auto&) { task.handles[1] = 25; }),
            "handle 1 is at the vertex 25, but the vertices are 0 to 24");
  EXPECT_EQ(words([](Task& task, auto&) { task.handles[1] = task.handles[0]; }),
            "handle 1 is at the vertex 0, where an earlier one is already; leave one out");
  EXPECT_EQ(words([](Task& task, auto&) { task.handles.pop_back(); }),
            "there are 2 rows of targets for 1 handles; give one for each");
  EXPECT_EQ(
      words([](Task& task, auto&) { task.rest(7, 0) = std::numeric_limits<double>::quiet_NaN(); }),
      "row 7 of rest positions is not finite; every coordinate must be a number");
  EXPECT_EQ(words([](Task&, SolveOptions& options) { options.energy = "no"; }).substr(0, 40),
            "there is no energy 'no'; choose one of: ");
  EXPECT_EQ(words([](Task&, SolveOptions& options) { options.time_limit = 0; }),
            "the time limit is 0.000000; give a number above 0, or none");
  EXPECT_NE(words([](Task& task, auto&) {
              task.triangles.row(0).reverseInPlace();
            }).find("in the same direction"),
            std::string::npos);
  EXPECT_NE(words([](Task& task, auto&) {
              task.triangles.col(0).swap(task.triangles.col(1));
            }).find("is clockwise"),
            std::string::npos);
}

TEST(Check, CountsWhatIsFoldedAndMeasuresWhatIsNot) {
  const Task task = test::pulled_square(4);
  PointMatrix stretched = task.rest;
  stretched.col(0) *= 2;
  const CheckedMap good = check(task.rest, task.triangles, stretched);
  EXPECT_TRUE(good.is_injective());
  EXPECT_NEAR(good.min_area_ratio, 2, 1e-12);
  EXPECT_NEAR(good.max_conformal_distortion, 2, 1e-12);
  EXPECT_NEAR(good.mean_conformal_distortion, 2, 1e-12);

  PointMatrix mirrored = task.rest;
  mirrored.col(0) *= -1;
  const CheckedMap bad = check(task.rest, task.triangles, mirrored);
  EXPECT_FALSE(bad.is_injective());
  EXPECT_TRUE(bad.rest.is_injective());
  EXPECT_EQ(bad.deformed.inverted, 32);
}

TEST(Energies, AreNamedAndZeroForNoDeformationOrConstant) {
  const Task task = test::pulled_square(4);
  EXPECT_GE(energies().size(), 5U);
  for (const EnergyWords& energy : energies())
    EXPECT_TRUE(energy_densities(task.rest, task.triangles, task.rest, energy.name).allFinite());
  EXPECT_NEAR(distortion_energy(task.rest, task.triangles, task.rest, "arap"), 0, 1e-15);
}

TEST(LibraryVersion, IsThatOfTheHeaders) { EXPECT_STREQ(library_version(), FOLDLESS_VERSION); }

}  // namespace
}  // namespace foldless
