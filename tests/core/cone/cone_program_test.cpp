// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions prove themselves: the conditions of optimality and the certificates are recomputed
// here from the program alone.
#include "core/cone/cone_program.h"

#include <gtest/gtest.h>

#include "core/cone/second_order_cone.h"
#include "core/method/conformal_system.h"
#include "tests/core/method/method_fixture.h"

namespace foldless {
namespace {

/// The unit square in 5 × 5 cells, its corners held, an inner vertex pulled.
Problem reference_problem(std::string_view energy) {
  const Shape shape = grid({.columns = 5, .rows = 5});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density(energy), {}, {}};
  for (const int v : {0, 5, 35, 30, 14}) problem.handles.push_back(test::held(shape.rest, v));
  problem.handles.back().target = Vec2(0.75, 0.55);
  return problem;
}

/// A program with what it was made from.
struct Posed {
  explicit Posed(const Problem& problem)
      : system(problem, "test"),
        targets(constraints_of(problem.handles).targets),
        u(system.with_handles(problem.mesh.deformed(), targets)) {}

  /// [Lip12]'s program for rest frames.
  ConeProgram bounded(double K) const {
    TriangleTerm term = system.energy_term(1);
    term.R(0, 0) = dilatation_bound(K);
    term.R(1, 2) = term.R(2, 3) = 1;
    return program([&](std::size_t) { return term; });
  }

  /// [AL13]'s first program: half-planes, towards the minimiser.
  ConeProgram projection(double K, const Points& minimum) const {
    const std::vector<ConformalParts> parts = system.parts(minimum);
    return program([&](std::size_t t) {
      const ConformalParts& now = parts[t];
      const Complex z = direction_of(now.f_z, 1), zbar = direction_of(now.f_zbar, 1);
      TriangleTerm term{2, 2, now.f_z, now.f_zbar};
      term.R.row(0) << dilatation_bound(K) * z.real(), dilatation_bound(K) * z.imag(), -zbar.real(),
          -zbar.imag();
      return term;
    });
  }

  ConeProgram program(const TermOfTriangle& term_of) const {
    ConeProgram program;
    EXPECT_TRUE(system.make_program({u, targets, term_of}, {}, program));
    return program;
  }

  ConformalSystem system;
  Points targets;
  Points u;
};

double cost_towards(const ConformalSystem& system, const Points& from, const Points& to,
                    const Problem& problem) {
  double sum = 0;
  const Triangles& triangles = problem.mesh.triangles();
  for (const auto& t : triangles.colwise())
    sum +=
        signed_area(problem.mesh.rest(), t) * (deformation_gradient(problem.mesh.rest(), from, t) -
                                               deformation_gradient(problem.mesh.rest(), to, t))
                                                  .squaredNorm();
  EXPECT_GT(system.triangle_count(), 0);
  return sum;
}

/// Optimal exactly when s = Gx + g and z are in the cones, Px + q = Gᵀz and sᵀz = 0.
void expect_optimal(const ConeProgram& program, const ConeSolution& solution, double tolerance) {
  ASSERT_EQ(solution.status, ConeStatus::solved);
  Eigen::VectorXd dual = Eigen::VectorXd::Zero(solution.x.size());
  double gap = 0;
  for (std::size_t t = 0; t < program.size(); ++t) {
    const ConeElement& e = program[t];
    const CornerVector c = corners_of(solution.x, e);
    const Cone3 s = e.G * c + e.g;
    const Cone3 z = solution.z.col(static_cast<Eigen::Index>(t));
    EXPECT_GE(depth(s), -tolerance) << t;
    EXPECT_GE(depth(z), 0) << t;
    add_corners(e.P * c + e.q - e.G.transpose() * z, e, dual);
    gap += s.dot(z);
  }
  EXPECT_LT(dual.cwiseAbs().maxCoeff(), 10 * tolerance);
  EXPECT_NEAR(gap, 0, 100 * tolerance);
}

/// Farkas: were Gx + g in the cones for an x of moderate size, then zᵀ(Gx + g) ≥ 0.
void expect_certificate(const ConeProgram& program, const ConeSolution& solution) {
  ASSERT_EQ(solution.status, ConeStatus::infeasible);
  Eigen::VectorXd Gz = Eigen::VectorXd::Zero(solution.x.size());
  double gz = 0;
  for (std::size_t t = 0; t < program.size(); ++t) {
    const Cone3 z = solution.z.col(static_cast<Eigen::Index>(t));
    EXPECT_GE(depth(z), 0) << t;
    add_corners(program[t].G.transpose() * z, program[t], Gz);
    gz += program[t].g.dot(z);
  }
  ASSERT_LT(gz, 0);
  EXPECT_LT(Gz.cwiseAbs().maxCoeff() / -gz, 1e-6);
}

struct OtherSolver {
  const char* energy;
  double K;
  double energy_value;
};

TEST(ConeProgram, BoundedConformalProgramsHaveTheEnergiesOfAnotherSolver) {
  for (const auto& [energy, K, value] :
       {OtherSolver{"dirichlet", 1.8, .114948887}, OtherSolver{"dirichlet", 2.4, .101081213},
        OtherSolver{"lscm", 1.8, .067708038}, OtherSolver{"lscm", 2.4, .065811077}}) {
    SCOPED_TRACE(testing::Message() << energy << " K " << K);
    Posed posed(reference_problem(energy));
    const ConeProgram program = posed.bounded(K);
    const ConeSolution solution = posed.system.solver.solve(program, 1e-9, {});
    expect_optimal(program, solution, 1e-8);
    EXPECT_NEAR(posed.system.energy(posed.system.moved(posed.u, solution.x)), value, 1e-6);
    EXPECT_LT(solution.iterations, 40);
  }
}

TEST(ConeProgram, HalfPlanesGiveTheProgramsOfInjectiveProjection) {
  for (const auto& [energy, K, value] :
       {OtherSolver{"dirichlet", 1.8, .02496975}, OtherSolver{"dirichlet", 2.4, .00240798},
        OtherSolver{"lscm", 1.8, .00163097}}) {
    SCOPED_TRACE(testing::Message() << energy << " K " << K);
    const Problem problem = reference_problem(energy);
    Posed posed(problem);
    const Points minimum = *posed.system.unconstrained_minimum(posed.u, posed.targets, {});
    const ConeProgram program = posed.projection(K, minimum);
    const ConeSolution solution = posed.system.solver.solve(program, 1e-9, {});
    expect_optimal(program, solution, 1e-8);
    EXPECT_NEAR(
        cost_towards(posed.system, posed.system.moved(posed.u, solution.x), minimum, problem),
        value, 1e-6);
  }
}

TEST(ConeProgram, WhatCannotBeIsProvedToBeImpossible) {
  for (const double K : {1.2, 1.4, 1.5}) {
    SCOPED_TRACE(K);
    Posed posed(reference_problem("dirichlet"));
    const ConeProgram program = posed.bounded(K);
    expect_certificate(program, posed.system.solver.solve(program, 1e-9, {}));
  }
}

TEST(ConeProgram, WithoutActiveConstraintsItIsTheUnconstrainedMinimum) {
  Posed posed(reference_problem("dirichlet"));
  const Points minimum = *posed.system.unconstrained_minimum(posed.u, posed.targets, {});
  ASSERT_TRUE(posed.system.is_bounded(minimum, 30));
  const ConeSolution solution = posed.system.solver.solve(posed.bounded(1e3), 1e-9, {});
  EXPECT_LT((posed.system.moved(posed.u, solution.x) - minimum).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(ConeProgram, ACancelledSolveSaysSo) {
  Posed posed(reference_problem("dirichlet"));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(posed.system.solver.solve(posed.bounded(2), 1e-9, source.get_token()).status,
            ConeStatus::cancelled);
}

TEST(ConeProgram, AStoppedProgramSaysSoAndItsMemoryServesTheNext) {
  const Posed posed(reference_problem("arap"));
  const TermOfTriangle cost = [&](std::size_t) { return posed.system.energy_term(1); };
  const Points moved = 2 * posed.u;
  const ProgramParts first{posed.u, posed.targets, cost}, second{moved, posed.targets, cost};
  std::stop_source source;
  source.request_stop();
  ConeProgram program;
  EXPECT_FALSE(posed.system.make_program(first, source.get_token(), program));
  EXPECT_TRUE(program.empty());
  ASSERT_TRUE(posed.system.make_program(first, {}, program));
  const ConeElement* memory = program.data();
  ASSERT_TRUE(posed.system.make_program(second, {}, program));
  EXPECT_EQ(program.data(), memory);
  ConeProgram fresh;
  ASSERT_TRUE(posed.system.make_program(second, {}, fresh));
  ASSERT_EQ(program.size(), fresh.size());
  for (std::size_t t = 0; t < fresh.size(); ++t) {
    EXPECT_EQ(program[t].q, fresh[t].q) << t;
    EXPECT_EQ(program[t].P, fresh[t].P) << t;
  }
}

TEST(ConeProgram, AStoppedFactorizationOfTheCostSaysSoAndTheNextIsWhole) {
  Posed posed(reference_problem("dirichlet"));
  const ConeProgram program = posed.bounded(1e3);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(posed.system.solver.factorize_cost(program, source.get_token()));
  ASSERT_TRUE(posed.system.solver.factorize_cost(program, {}));
  const Points minimum = posed.system.moved(posed.u, posed.system.solver.minimize_cost(program));
  EXPECT_LT((minimum - *posed.system.unconstrained_minimum(posed.u, posed.targets, {}))
                .cwiseAbs()
                .maxCoeff(),
            1e-12);
}

TEST(ConeProgram, AProgramCanFollowAnotherAndACopySolvesTheSame) {
  Posed posed(reference_problem("dirichlet"));
  ConeSolver copy = posed.system.solver;
  const ConeSolution first = posed.system.solver.solve(posed.bounded(2.4), 1e-9, {});
  posed.system.solver.solve(posed.bounded(1.2), 1e-9, {});
  const ConeSolution again = posed.system.solver.solve(posed.bounded(2.4), 1e-9, {});
  EXPECT_EQ(first.x, again.x);
  EXPECT_EQ(first.x, copy.solve(posed.bounded(2.4), 1e-9, {}).x);
}

}  // namespace
}  // namespace foldless
