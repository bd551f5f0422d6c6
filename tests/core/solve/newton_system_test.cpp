// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/newton_system.h"

#include <gtest/gtest.h>

#include "core/solve/newton_step.h"
#include "tests/core/solve/newton_fixture.h"

namespace foldless {
namespace {

using test::DenseNewton;
using test::SqueezedGrid;

TEST(NewtonSystem, AStepSolvesEquationSix) {
  for (const double size : {0.9, 0.2}) {
    SCOPED_TRACE(size);
    SqueezedGrid s(size);
    DampedSystem system = s.system();
    system.assemble(s.energy, s.mesh.deformed());
    const double mu = system.factorize_damped(false, {}).value();
    EXPECT_EQ(mu > 0, size < 0.5);
    const DenseNewton dense(s.mesh, s.energy);
    EXPECT_EQ(system.gradient(), dense.gradient);
    const Points expected = dense.step(mu);
    EXPECT_LT((newton_step(system) - expected).norm(), 1e-9 * expected.norm());
    const double descent = dense.gradient.dot(expected.reshaped());
    EXPECT_NEAR(slope(system, expected), descent, 1e-12 * std::abs(descent));
    EXPECT_LT(descent, 0);
  }
}

TEST(NewtonSystem, HasAPlainFactorOfWhatWasAssembledLastOnly) {
  SqueezedGrid s(0.9);
  NewtonSystem system = s.system();
  const auto factorized = [&] {
    system.assemble(s.energy, s.mesh.deformed());
    EXPECT_FALSE(system.factor().is_exact());
    EXPECT_TRUE(factorize(system, 0));
    return system.factor().is_exact();
  };
  EXPECT_TRUE(factorized());
  EXPECT_TRUE(factorized()) << "and not what was assembled before";
  system.factor().outdate();
  EXPECT_FALSE(system.factor().is_exact());
  EXPECT_TRUE(factorized());
  system.follow_flips(s.mesh);
  EXPECT_FALSE(system.factor().is_exact());
  EXPECT_TRUE(factorized());
  system.rebuild(s.mesh, s.energy.constraints);
  EXPECT_FALSE(system.factor().is_exact());
  EXPECT_TRUE(factorized());
  EXPECT_TRUE(factorize(system, 1e-5));
  EXPECT_FALSE(system.factor().is_exact()) << "that of a shifted one";
}

TEST(NewtonSystem, FollowsFlipsAsIfItWereNew) {
  SqueezedGrid s(0.9);
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed());
  ASSERT_TRUE(factorize(system, 0));
  for (const auto& [a, b] : {Edge{0, 5}, Edge{5, 10}, Edge{6, 11}}) {
    s.mesh.flip(s.mesh.find_edge(a, b).value());
    system.follow_flips(s.mesh);
  }
  system.assemble(s.energy, s.mesh.deformed());
  ASSERT_TRUE(factorize(system, 0));
  const Points expected = DenseNewton(s.mesh, s.energy).step();
  EXPECT_LT((newton_step(system) - expected).norm(), 1e-9 * expected.norm());
}

TEST(NewtonSystem, TheOthersFollowCarriedHandlesAsTheDenseSystemSays) {
  SqueezedGrid s(0.8);
  const DenseNewton free(s.mesh, s.energy, 1);
  Points way = Points::Zero(2, s.mesh.vertex_count());
  way.col(3) = Vec2(0.1, -0.2);
  way.col(12) = Vec2(-0.05, 0.3);
  s.energy.constraints.held = true;
  NewtonSystem system = s.system();
  system.assemble(s.energy, s.mesh.deformed(), 1);
  ASSERT_TRUE(factorize(system, 0));
  const Points step = carrying_step(system, s.energy.settings, s.mesh.deformed(), way);
  // K_ff d_f = −∇E_f − K_fh δ, by taking rows and columns out of the dense system.
  std::vector<int> f, h;
  for (int v = 0; v < s.mesh.vertex_count(); ++v)
    for (const int i : {2 * v, 2 * v + 1})
      (v == 0 || v == 3 || v == 12 || v == 15 ? h : f).push_back(i);
  const Eigen::VectorXd delta = way.reshaped();
  const Eigen::VectorXd d_f =
      free.hessian(f, f).ldlt().solve(-free.gradient(f) - free.hessian(f, h) * delta(h));
  EXPECT_LT((step.reshaped()(f) - d_f).norm(), 1e-9 * d_f.norm());
  EXPECT_EQ(step.reshaped()(h), delta(h));
}

}  // namespace
}  // namespace foldless
