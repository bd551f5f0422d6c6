// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/line_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/energy/densities.h"
#include "core/mesh/injective.h"
#include "tests/support/meshes.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

/// A mesh whose vertices are all pulled to where a step leads, much more than the mesh resists.
struct Pulled {
  Pulled(const Triangles& triangles, const Points& rest, const Points& way, double delta,
         double alpha = 1e6)
      : mesh(triangles, rest), step(way) {
    std::vector<Handle> handles;
    for (int v = 0; v < mesh.vertex_count(); ++v)
      handles.push_back({.id = v, .vertex = v, .target = rest.col(v) + way.col(v)});
    energy = {{find_density("arap"), alpha, 0.01, delta}, constraints_of(handles)};
  }
  LineSearchResult search() const {
    const Objective objective(mesh, energy.constraints);
    const EnergyGradient at_start = objective.gradient(energy, mesh.deformed());
    return line_search(
        objective, energy,
        {mesh.deformed(), step, at_start.energy.total(), at_start.gradient.dot(step.reshaped())});
  }

  MeshPair mesh;
  Points step;
  Energy energy;
};

/// The smallest A′/A on the way at t.
double smallest_ratio(const MeshPair& mesh, const Points& step, double t) {
  const Points u = mesh.deformed() + t * step;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles().colwise())
    smallest = std::min(smallest, signed_area(u, triangle) / signed_area(mesh.rest(), triangle));
  return smallest;
}

/// Everything on the way up to `end`, in so many places, is proved locally injective and feasible.
void expect_open_way(const Pulled& pulled, double end, int places) {
  const InjectivityChecker checker(pulled.mesh.triangles(), pulled.mesh.vertex_count());
  for (int k = 0; k <= places; ++k) {
    const double t = end * k / places;
    ASSERT_TRUE(checker.is_injective(pulled.mesh.deformed() + t * pulled.step)) << "at " << t;
    ASSERT_GT(smallest_ratio(pulled.mesh, pulled.step, t), pulled.energy.settings.delta)
        << "at " << t;
  }
}

/// The middle of a hexagon on its way up: the triangle above is flat after √3/2.
Pulled middle_of_a_hexagon(double way, double delta) {
  const auto f = test::hexagon();
  Points step = Points::Zero(2, 7);
  step.col(0) = Vec2(0, way);
  return {f.triangles, f.rest, step, delta};
}

TEST(LineSearch, TheFirstTrialIsEightTenthsOfTheWayToTheFirstFold) {
  const double delta = 0.2;
  const LineSearchResult found = middle_of_a_hexagon(10, delta).search();
  EXPECT_NEAR(found.step_length, 0.8 * (1 - delta) * std::sqrt(0.75) / 10, 1e-13);
}

TEST(LineSearch, TheFirstTrialIsTheFullStepWhereEightTenthsReachFurther) {
  // 0.8 t_max is 1.04, and 0.99 a little further.
  const double far = (1 - 1e-5) * std::sqrt(0.75) * 0.8;
  EXPECT_EQ(middle_of_a_hexagon(far / 1.04, 1e-5).search().step_length, 1);
  EXPECT_NEAR(middle_of_a_hexagon(far / 0.99, 1e-5).search().step_length, 0.99, 1e-12);
}

TEST(LineSearch, NoPathFoldsInBetweenToAnEndThatIsFine) {
  // Every vertex goes straight to its opposite place: a half turn at the end, a point half way.
  const auto f = test::hexagon();
  const Pulled pulled(f.triangles, f.rest, -2 * f.rest, 1e-4);
  const Objective objective(pulled.mesh, pulled.energy.constraints);
  ASSERT_LT(objective.value(pulled.energy, -f.rest).total(), 1e-9) << "the end is the minimum";
  const LineSearchResult found = pulled.search();
  // A′/A = (1 − 2t)² reaches δ.
  EXPECT_NEAR(found.step_length, 0.8 * (1 - std::sqrt(1e-4)) / 2, 1e-12);
  expect_open_way(pulled, found.step_length, 100);
}

TEST(LineSearch, NoTriangleFoldsAnywhereOnTheWay) {
  int bounded = 0, fine_at_the_end = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const Shape shape = test::random_shape(random);
    // A turn and a stretch at random, as a straight way for every vertex, and a little noise.
    Mat2 map;
    map << unit(random), unit(random), unit(random), unit(random);
    Points step = 3 * map * shape.rest;
    for (Eigen::Index i = 0; i < step.size(); ++i) step.data()[i] += 1e-3 * unit(random);
    const double delta = seed % 2 ? 1e-5 : 0.3;
    const Pulled pulled(shape.triangles, shape.rest, step, delta);
    const LineSearchResult found = pulled.search();
    ASSERT_GT(found.step_length, 0);
    ASSERT_LE(found.step_length, 1);
    EXPECT_EQ(found.u, shape.rest + found.step_length * step);
    expect_open_way(pulled, found.step_length, 50);
    if (found.step_length == 1) continue;
    ++bounded;
    fine_at_the_end += smallest_ratio(pulled.mesh, step, 1) > delta;
    // The search stopped for a triangle: 0.8 of the way to where one reaches δ, or half of that …
    double bound = found.step_length / 0.8;
    while (smallest_ratio(pulled.mesh, step, bound) > delta + 1e-9 && bound <= 2) bound *= 2;
    EXPECT_NEAR(smallest_ratio(pulled.mesh, step, bound), delta, 1e-9);
  }
  EXPECT_GT(bounded, 80) << "the claim would be empty";
  EXPECT_GT(fine_at_the_end, 5) << "the claim would not tell the way from its end";
}

/// E along the step is a quadratic here: −1 a unit of t at the start, and at t = 1 the decrease is
/// the part `decrease` of that.
LineSearchResult search_with_decrease(double decrease) {
  const auto f = test::hexagon();
  Points way = Points::Zero(2, 7);
  way.col(0) = Vec2(0.01, 0);
  Pulled pulled(f.triangles, f.rest, way, 1e-5, 1);
  pulled.energy.settings.density = find_density("dirichlet");
  pulled.energy.settings.beta = 0;
  const Objective objective(pulled.mesh, pulled.energy.constraints);
  const auto energy_at = [&](double t) {
    return objective.value(pulled.energy, f.rest + t * way).total();
  };
  // E(t) = E(0) − a t + b t²: its minimum is at a / 2b, and its decrease is 0 at a / b.
  const double e0 = energy_at(0), e1 = energy_at(1), e2 = energy_at(2);
  const double b = (e2 - 2 * e1 + e0) / 2, a = e0 + b - e1;
  pulled.step *= (1 - decrease) * a / b;
  return pulled.search();
}

TEST(LineSearch, TheDecreaseIsAtLeastATenThousandthOfWhatTheSlopePromises) {
  EXPECT_EQ(search_with_decrease(1.1e-4).step_length, 1);
  EXPECT_EQ(search_with_decrease(0.9e-4).step_length, 0.5);
  EXPECT_EQ(search_with_decrease(0.5e-4).step_length, 0.5);
}

TEST(LineSearch, EDoesNotRise) {
  EXPECT_EQ(search_with_decrease(-0.5e-4).step_length, 0.5);
  EXPECT_EQ(search_with_decrease(-1.5).step_length, 0.25);
}

TEST(LineSearch, WhereNothingDecreasesNothingMoves) {
  const auto f = test::hexagon();
  Points step = Points::Zero(2, 7);
  step.col(0) = Vec2(0.1, 0);
  const Pulled at_rest(f.triangles, f.rest, Points::Zero(2, 7), 1e-5);
  const Objective objective(at_rest.mesh, at_rest.energy.constraints);
  const double energy = objective.value(at_rest.energy, f.rest).total();
  ASSERT_LT(energy, 1e-25) << "the rest state is the minimum";
  const LineSearchResult found = line_search(objective, at_rest.energy, {f.rest, step, energy, -1});
  EXPECT_EQ(found.step_length, 0);
  EXPECT_EQ(found.u, f.rest);
}

}  // namespace
}  // namespace foldless
