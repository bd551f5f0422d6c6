// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a NewtonSystem from an earlier factor.
#include <gtest/gtest.h>

#include <vector>

#include "core/solve/newton_step.h"
#include "tests/core/solve/newton_fixture.h"

namespace foldless {
namespace {

using test::DenseNewton;
using test::SqueezedGrid;

/// A grid with a factor of its ∇²E, that moved a little since.
struct Moved : SqueezedGrid {
  Moved() : SqueezedGrid(0.9), newton(system()) {
    newton.assemble(energy, mesh.deformed());
    EXPECT_TRUE(factorize(newton, 0));
    Points u = mesh.deformed();
    u.row(0) += 0.01 * u.row(1);
    mesh.set_deformed(u);
    newton.factor().outdate();
  }
  /// What the factor gives for this energy where the mesh is.
  std::optional<LaggedStep> lagged(const Energy& other) {
    newton.assemble(other, mesh.deformed());
    return lagged_newton_step(newton);
  }

  NewtonSystem newton;
};

TEST(LaggedStep, IsNearlyNewtonsWithoutAFactorization) {
  Moved m;
  const std::optional<LaggedStep> lagged = m.lagged(m.energy);
  ASSERT_TRUE(lagged);
  EXPECT_FALSE(lagged->is_indefinite);
  EXPECT_EQ(m.effort.factorizations, 1);
  const DenseNewton dense(m.mesh, m.energy);
  const Points newton = dense.step();
  // Of the decrease that the quadratic model promises little is missing.
  const auto model = [&](const Points& step) {
    const Eigen::VectorXd s = step.reshaped();
    return dense.gradient.dot(s) + 0.5 * s.dot(dense.hessian * s);
  };
  EXPECT_LT(model(lagged->step), 0.95 * model(newton));
  EXPECT_GT((lagged->step - newton).norm(), 1e-9 * newton.norm()) << "or it is Newton's own";
}

TEST(LaggedStep, AnotherPenaltyOrConformalWeightDoesNotOutdateAFactor) {
  Moved m;
  Energy other = m.energy;
  other.settings.alpha *= 1.1;
  other.settings.conformal_weight = 1e-3;
  EXPECT_TRUE(m.lagged(other));
}

TEST(LaggedStep, AFactorOfAnotherEnergyDoesNotServe) {
  Energy held_handles = Moved().energy, denser = held_handles, stiffer = held_handles,
         equilateral = held_handles;
  held_handles.constraints.held = true;
  denser.settings.density = find_density("symmetric-dirichlet");
  stiffer.settings.beta *= 1.1;
  equilateral.settings.reference = Reference::equilateral;
  for (const Energy* other : {&held_handles, &denser, &stiffer, &equilateral}) {
    Moved m;
    EXPECT_FALSE(m.lagged(*other));
    EXPECT_TRUE(m.lagged(m.energy)) << "it serves its own afterwards";
  }
}

TEST(LaggedStep, AnOutdatedFactorDoesNotServeUntilThereIsANewOne) {
  Moved m;
  m.newton.factor().set_far();
  EXPECT_FALSE(m.lagged(m.energy));
  ASSERT_TRUE(factorize(m.newton, 0));
  EXPECT_TRUE(m.lagged(m.energy));
  m.newton.rebuild(m.mesh, m.energy.constraints);
  EXPECT_FALSE(m.lagged(m.energy)) << "a mesh that was made anew";
}

TEST(LaggedStep, AFailedFactorizationLeavesNoFactor) {
  Moved m;
  SqueezedGrid indefinite(0.2);
  m.newton.assemble(indefinite.energy, indefinite.mesh.deformed());
  ASSERT_FALSE(factorize(m.newton, 0));
  EXPECT_FALSE(m.lagged(m.energy));
}

TEST(LaggedStep, StoppedThereIsNoneAndTheFactorServesOn) {
  Moved m;
  std::stop_source stop;
  stop.request_stop();
  m.newton.factor().obey(stop.get_token());
  EXPECT_FALSE(m.lagged(m.energy));
  m.newton.factor().obey({});
  EXPECT_TRUE(m.lagged(m.energy));
}

TEST(LaggedStep, TellsAnIndefiniteHessian) {
  Moved m;
  SqueezedGrid indefinite(0.2);
  m.newton.assemble(indefinite.energy, indefinite.mesh.deformed());
  const std::optional<LaggedStep> lagged = lagged_newton_step(m.newton);
  ASSERT_TRUE(lagged);
  EXPECT_TRUE(lagged->is_indefinite);
}

/// A grid with a factor of its clamped ∇²E with handles held, that moved a little since and one of
/// whose handles is to be carried.
struct MovedAndHeld : Moved {
  MovedAndHeld() : u(mesh.deformed()), way(Points::Zero(2, mesh.vertex_count())) {
    energy.constraints.held = true;
    newton.assemble(energy, u, 1);
    EXPECT_TRUE(factorize(newton, 0));
    u.row(0) += 0.01 * u.row(1);
    newton.assemble(energy, u, 1);
    way.col(15) = Vec2(0.2, 0.1);
  }
  std::optional<LaggedStep> lagged() {
    return lagged_carrying_step(newton, energy.settings, u, way);
  }
  Points exact() {
    EXPECT_TRUE(factorize(newton, 0));
    return carrying_step(newton, energy.settings, u, way);
  }

  Points u, way;
};

TEST(LaggedStep, CarriesHandlesNearlyAsAFactorOfItsOwn) {
  MovedAndHeld c;
  const auto lagged = c.lagged();
  ASSERT_TRUE(lagged && !lagged->is_indefinite);
  const Points exact = c.exact();
  EXPECT_EQ(lagged->step.col(15), c.way.col(15));
  EXPECT_LT((lagged->step - exact).norm(), 0.05 * exact.norm());
}

TEST(LaggedStep, CarriesHandlesFromHowTheVerticesFollowedBefore) {
  MovedAndHeld first, second, third;
  const Points exact = third.exact();
  const auto cold = first.lagged();
  ASSERT_TRUE(cold);
  ASSERT_EQ(first.newton.followings().size(), 1U);
  EXPECT_EQ(first.newton.followings().front(), (cold->step - first.way).reshaped());
  const Eigen::VectorXd followed = third.newton.followings().front();
  // In two parts, as if the handle had gone two ways.
  const Eigen::VectorXd part = Eigen::VectorXd::LinSpaced(followed.size(), -1, 1);
  second.newton.has_followed(part);
  second.newton.has_followed(followed - part);
  const auto warm = second.lagged();
  ASSERT_TRUE(warm);
  EXPECT_GT((cold->step - exact).norm(), 1e-9 * exact.norm());
  EXPECT_LT((warm->step - exact).norm(), 1e-12 * exact.norm());
}

TEST(LaggedStep, ThreeWaysThatTheVerticesFollowedAreKept) {
  MovedAndHeld c;
  for (int i = 1; i <= 5; ++i) c.newton.has_followed(Eigen::VectorXd::Constant(2, i));
  std::vector<double> kept;
  for (const Eigen::VectorXd& following : c.newton.followings()) kept.push_back(following[0]);
  EXPECT_EQ(kept, (std::vector<double>{5, 4, 3}));
}

}  // namespace
}  // namespace foldless
