// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/boundary_guard.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "core/energy/densities.h"
#include "core/energy/objective.h"
#include "core/mesh/boundary.h"
#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "tests/support/dense_matrix.h"
#include "tests/support/finite_difference.h"
#include "tests/support/notched_disk.h"
#include "tests/support/random_scene.h"

namespace foldless {
namespace {

using std::numbers::pi;

EnergySettings guarded() {
  EnergySettings settings;
  settings.density = find_density("arap");
  settings.beta = 2;
  settings.barrier_area_weighted = true;
  settings.gap_weight = 0.5;
  return settings;
}

EnergySettings unguarded() {
  EnergySettings settings = guarded();
  settings.gap_weight = 0;
  return settings;
}

/// A notched disk whose notch is narrower than it was, so that its barrier is at work.
struct NarrowNotch {
  explicit NarrowNotch(std::vector<Handle> handles = {}, double now = 0.3)
      : f(test::notched_disk(0.8)),
        mesh(f.triangles, f.rest, test::with_notch(f.rest, 0.8, now)),
        guarded_energy{guarded(), constraints_of(handles)},
        plain_energy{unguarded(), constraints_of(handles)},
        objective(mesh, guarded_energy.constraints) {}

  test::Fixture f;
  MeshPair mesh;
  Energy guarded_energy, plain_energy;
  Objective objective;
};

TEST(BoundaryGuard, WeighsWithAThirdOfTheRestAreaRoundTheVertex) {
  const NarrowNotch notch;
  const Points& u = notch.mesh.deformed();
  const double x = 0.3 / 0.8, b = -(1 - x) * (1 - x) * std::log(x);
  double area = 0;
  for (const int t : notch.mesh.triangles_of_vertex(0))
    area += signed_area(notch.f.rest, notch.f.triangles.col(t));
  EXPECT_NEAR(notch.objective.value(notch.guarded_energy, u).total() -
                  notch.objective.value(notch.plain_energy, u).total(),
              0.5 * area / 3 * b, 1e-12);
}

TEST(BoundaryGuard, IsNothingAtRest) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const Shape shape = test::random_shape(random);
    const MeshPair mesh(shape.triangles, shape.rest);
    const Objective objective(mesh, {});
    EXPECT_EQ(objective.value({guarded(), {}}, shape.rest).barrier,
              objective.value({unguarded(), {}}, shape.rest).barrier)
        << seed;
  }
  for (const double gap : {1e-3, 0.1, 1.0, 3.0}) {
    const test::Fixture f = test::notched_disk(gap);
    const MeshPair mesh(f.triangles, f.rest);
    const Points turned = Eigen::Rotation2Dd(1).toRotationMatrix() * f.rest;
    EXPECT_LT(Objective(mesh, {}).value({guarded(), {}}, turned).barrier, 1e-25) << gap;
  }
}

TEST(BoundaryGuard, EAndItsGradientAgreeWithFiniteDifferences) {
  const NarrowNotch notch({{.vertex = 3, .target = Vec2(1, 1)}});
  const Energy& e = notch.guarded_energy;
  const Objective& objective = notch.objective;
  SparseSymmetric hessian = objective.hessian_pattern();
  const Points& u = notch.mesh.deformed();
  const auto [energy, gradient] = objective.assemble(e, u, hessian);
  const EnergyGradient by_itself = objective.gradient(e, u);
  EXPECT_EQ(by_itself.gradient, gradient);
  EXPECT_NEAR(energy.total(), objective.value(e, u).total(), 1e-14 * energy.total());
  EXPECT_NEAR(by_itself.energy.total(), energy.total(), 1e-14 * energy.total());
  const auto part_of_gaps = [&](const Eigen::VectorXd& x) {
    const Points y = x.reshaped(2, x.size() / 2);
    return Eigen::VectorXd::Constant(
        1, objective.value(e, y).barrier - objective.value(notch.plain_energy, y).barrier);
  };
  const Eigen::VectorXd of_gaps = gradient - objective.gradient(notch.plain_energy, u).gradient;
  ASSERT_GT(of_gaps.norm(), 1e-3);
  EXPECT_LT(test::relative_difference(
                test::finite_difference(part_of_gaps, u.reshaped(), 1e-4).transpose(), of_gaps),
            1e-6);
}

TEST(BoundaryGuard, ItsHessianIsNotLessThanFiniteDifferencesOfTheGradient) {
  const NarrowNotch notch;
  const Points& u = notch.mesh.deformed();
  SparseSymmetric with = notch.objective.hessian_pattern(), without = with;
  notch.objective.assemble(notch.guarded_energy, u, with);
  notch.objective.assemble(notch.plain_energy, u, without);
  const Eigen::MatrixXd of_gaps = test::dense(with) - test::dense(without);
  const Eigen::MatrixXd numeric = test::finite_difference(
      [&](const Eigen::VectorXd& x) {
        const Points y = x.reshaped(2, x.size() / 2);
        return Eigen::VectorXd(notch.objective.gradient(notch.guarded_energy, y).gradient -
                               notch.objective.gradient(notch.plain_energy, y).gradient);
      },
      u.reshaped(), 1e-4);
  ASSERT_GT(numeric.norm(), 1e-2);
  EXPECT_GT(test::smallest_eigenvalue(of_gaps), -1e-10 * of_gaps.norm());
  EXPECT_GT(test::smallest_eigenvalue(of_gaps - numeric), -1e-6 * of_gaps.norm());
}

TEST(BoundaryGuard, HandlesPullByTheirPartOfIt) {
  std::vector<Handle> handles{{.id = 0, .vertex = 1}, {.id = 1, .vertex = 12}};
  for (const int held_vertex : {0, 1, 9}) {
    handles[0].vertex = held_vertex;
    NarrowNotch notch(handles);
    const Points& u = notch.mesh.deformed();
    SparseSymmetric hessian = notch.objective.hessian_pattern(), fixed = hessian;
    notch.objective.assemble({guarded(), {}}, u, hessian, 1);
    Points way = Points::Zero(2, u.cols());
    way.col(held_vertex) = Vec2(0.3, -0.2);
    way.col(12) = Vec2(-0.1, 0.4);
    Eigen::VectorXd expected = test::dense(hessian) * way.reshaped();
    for (const int v : {held_vertex, 12}) expected.segment<2>(2 * v).setZero();
    const Eigen::VectorXd pull = notch.objective.pull_of_handles(guarded(), u, way);
    EXPECT_LT((pull - expected).norm(), 1e-12 * expected.norm());
    EXPECT_GT((notch.objective.pull_of_handles(unguarded(), u, way) - pull).norm(), 1e-4);

    notch.guarded_energy.constraints.held = true;
    notch.objective.assemble(notch.guarded_energy, u, fixed, 1);
    Eigen::MatrixXd rows = test::dense(hessian);
    for (const int v : {held_vertex, 12})
      for (const int i : {2 * v, 2 * v + 1}) {
        rows.row(i).setZero();
        rows.col(i).setZero();
        rows(i, i) = 1;
      }
    EXPECT_LT((test::dense(fixed) - rows).norm(), 1e-12 * rows.norm());
  }
}

TEST(BoundaryGuard, FollowsFlipsAsIfItWereNew) {
  NarrowNotch notch;
  int flips = 0;
  for (int e = 0; e < notch.mesh.edge_count() && flips < 3; ++e)
    if (notch.mesh.is_flip_legal(e) && notch.mesh.edge(e)[0] == 0) {
      notch.mesh.flip(e);
      flips += 1;
    }
  ASSERT_GT(flips, 0);
  const Objective anew(notch.mesh, {});
  notch.objective.follow_flips(notch.mesh);
  for (const double now : {0.1, 0.5}) {
    const Points u = test::with_notch(notch.f.rest, 0.8, now);
    const BoundaryGuard of_flipped(notch.mesh);
    EXPECT_EQ(notch.objective.gradient({guarded(), {}}, u).gradient,
              anew.gradient({guarded(), {}}, u).gradient);
  }
}

/// Whether a vertex on the way is not proved injective, in so many places.
bool breaks_on_the_way(const MeshPair& mesh, const Points& step, double end) {
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  for (int k = 0; k <= 200; ++k)
    if (!checker.is_injective(mesh.deformed() + end * k / 200 * step)) return true;
  return false;
}

TEST(BoundaryGuard, StepsAreBoundedWhereTheFirstGapCloses) {
  int bound_by_a_gap = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double gap = 0.05 + 2 * std::abs(unit(random));
    const test::Fixture f = test::notched_disk(gap, 6 + static_cast<int>(random() % 7));
    const MeshPair mesh(f.triangles, f.rest);
    // About the turn that closes the notch, and a little noise.
    Points step = test::with_notch(f.rest, gap, gap / 3) - f.rest;
    for (Eigen::Index i = 0; i < step.size(); ++i) step.data()[i] += 0.2 * gap * unit(random);
    const Objective objective(mesh, {});
    const double guarded_end = objective.largest_step(guarded(), f.rest, step);
    const double plain_end = objective.largest_step(unguarded(), f.rest, step);
    ASSERT_LE(guarded_end, plain_end);
    EXPECT_FALSE(breaks_on_the_way(mesh, step, 0.999 * std::min(guarded_end, 100.0)));
    if (guarded_end == plain_end) continue;
    ++bound_by_a_gap;
    const Points after = f.rest + 1.0001 * guarded_end * step;
    EXPECT_FALSE(overlapping_boundary_vertices(f.triangles, after).empty());
  }
  EXPECT_GT(bound_by_a_gap, 150) << "the claim would be empty";
}

TEST(BoundaryGuard, AGapMayOpenAndNarrowPastHalfATurn) {
  const test::Fixture f = test::notched_disk(1.5 * pi, 3);
  const MeshPair mesh(f.triangles, f.rest);
  Points step = Points::Zero(2, f.rest.cols());
  step.col(1) = Vec2(0.4, 0.05);  // upwards from the left to the right: its side turns by a third
  step.col(5) = step.col(1);
  EXPECT_EQ(Objective(mesh, {}).largest_step(guarded(), f.rest, step),
            Objective(mesh, {}).largest_step(unguarded(), f.rest, step));
}

TEST(BoundaryGuard, LeavesOutVerticesThatOverlapAlready) {
  const test::Fixture f = test::notched_disk(0.3);
  const Points overlapping = test::with_notch(f.rest, 0.3, -0.1);
  ASSERT_EQ(overlapping_boundary_vertices(f.triangles, overlapping), std::vector<int>{0});
  const Points step = f.rest - overlapping;
  const MeshPair deformed(f.triangles, f.rest, overlapping);
  const MeshPair at_rest(f.triangles, overlapping, overlapping);
  for (const MeshPair* mesh : {&deformed, &at_rest}) {
    const Objective objective(*mesh, {});
    EXPECT_GT(objective.largest_step(guarded(), overlapping, step), 1) << "it may open";
    EXPECT_TRUE(std::isfinite(objective.value({guarded(), {}}, overlapping).total()));
    EXPECT_EQ(objective.value({guarded(), {}}, overlapping).barrier,
              objective.value({unguarded(), {}}, overlapping).barrier);
  }
}

/// The notch of some positions with its sides on one line but for rounding.
Points with_shut_notch(Points u, const BoundaryNeighbours& sides, std::mt19937_64& random) {
  const auto any = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  u.col(0) << 1 + any(), 1 + any();
  const Vec2 direction(1, any());
  for (const int v : {sides.next, sides.previous}) u.col(v) = u.col(0) + (0.1 + any()) * direction;
  return u;
}

TEST(BoundaryGuard, TellsExactlyWhetherAGapAsNarrowAsRoundingStaysOpen) {
  const NarrowNotch notch;
  const BoundaryGuard guard(notch.mesh);
  const Points& wide = notch.mesh.deformed();
  const BoundaryNeighbours sides =
      boundary_neighbours(notch.f.triangles, static_cast<int>(wide.cols()))[0];
  const auto turn_of = [&](const Points& u) {
    return orientation(u.col(0), u.col(sides.previous), u.col(sides.next));
  };
  int open = 0, closed = 0, rounding_says_otherwise = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const Points before = with_shut_notch(wide, sides, random);
    const Points end = with_shut_notch(wide, sides, random);
    EXPECT_FALSE(guard.stays_open(wide, end));
    if (turn_of(before) <= 0) continue;
    EXPECT_EQ(guard.stays_open(before, end), turn_of(end) > 0);
    ++(turn_of(end) > 0 ? open : closed);
    const double area =
        cross(end.col(sides.previous) - end.col(0), end.col(sides.next) - end.col(0));
    if ((area > 0) != (turn_of(end) > 0)) ++rounding_says_otherwise;
  }
  EXPECT_GT(open, 20);
  EXPECT_GT(closed, 20);
  EXPECT_GT(rounding_says_otherwise, 0) << "the claim would be empty";
}

TEST(BoundaryGuard, NoStepEndsWithAGapNarrowerThanItsFloor) {
  const NarrowNotch notch;
  const BoundaryGuard guard(notch.mesh);
  const auto at = [&](double gap) { return test::with_notch(notch.f.rest, 0.8, gap); };
  EXPECT_TRUE(guard.stays_open(at(0.3), at(1e-8)));
  EXPECT_FALSE(guard.stays_open(at(0.3), at(1e-10)));
  EXPECT_FALSE(guard.stays_open(at(1e-8), at(1e-10)));
  EXPECT_TRUE(guard.stays_open(at(1e-10), at(1e-11))) << "as it was so narrow before";
}

}  // namespace
}  // namespace foldless
