// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "core/energy/densities.h"
#include "core/energy/objective.h"
#include "core/energy/vertex_ranges.h"
#include "core/threads/team.h"
#include "tests/support/meshes.h"

namespace foldless {
namespace {

/// The vertices and triangles of a grid, in their order or in no order.
test::Fixture numbered_grid(int cells, bool in_order) {
  test::Fixture shape = test::square_grid(cells);
  if (in_order) return shape;
  std::mt19937 random(3);
  std::vector<int> of_vertex(static_cast<std::size_t>(shape.rest.cols()));
  std::iota(of_vertex.begin(), of_vertex.end(), 0);
  std::ranges::shuffle(of_vertex, random);
  const Points rest = shape.rest;
  for (Eigen::Index v = 0; v < rest.cols(); ++v)
    shape.rest.col(of_vertex[static_cast<std::size_t>(v)]) = rest.col(v);
  for (int& v : shape.triangles.reshaped()) v = of_vertex[static_cast<std::size_t>(v)];
  std::vector<int> order(static_cast<std::size_t>(shape.triangles.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, random);
  shape.triangles = Triangles(shape.triangles(Eigen::all, order));
  return shape;
}

class SharedObjective : public testing::TestWithParam<bool> {};

TEST_P(SharedObjective, SumsHaveTheSameBitsWithAnyNumberOfThreads) {
  const test::Fixture shape = numbered_grid(40, GetParam());
  ASSERT_EQ(
      compact_ranges(shape.triangles, static_cast<std::size_t>(shape.rest.cols()), 16).empty(),
      !GetParam())
      << "the sums would go another way";
  const MeshPair mesh(shape.triangles, shape.rest, shape.rest);
  Points u = shape.rest;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shake(-0.2, 0.2);
  for (double& x : u.reshaped()) x += shake(random);
  Energy energy{{.density = find_density("arap"), .gap_weight = 1e-3},
                constraints_of({{.id = 0, .vertex = 0, .target = shape.rest.col(0)}})};
  energy.constraints.held = true;
  Team team(3);
  struct Sums {
    double value;
    EnergyGradient first, second;
    std::vector<int> graph_start, graph;
    UnfilledVector<double> hessian;
    Eigen::VectorXd product;
    double bound;
  };
  std::vector<Sums> all;
  for (Team* asked : {static_cast<Team*>(nullptr), &team}) {
    const WithTeam with(asked);
    const Objective objective(mesh, energy.constraints);
    SparseSymmetric hessian = objective.hessian_pattern();
    Sums sums{
        objective.value(energy, u).total(), objective.gradient(energy, u), {}, {}, {}, {}, {}, 0};
    sums.second = objective.assemble(energy, u, hessian, 0.5);
    multiply(hessian, sums.second.gradient, sums.product);
    sums.graph_start = hessian.graph_start;
    sums.graph = hessian.graph;
    sums.hessian = hessian.value;
    sums.bound = objective.largest_step(energy.settings, u, -u);
    all.push_back(sums);
  }
  EXPECT_EQ(all[0].value, all[1].value);
  EXPECT_EQ(all[0].first.energy.total(), all[1].first.energy.total());
  EXPECT_EQ(all[0].first.gradient, all[1].first.gradient);
  EXPECT_EQ(all[0].second.energy.total(), all[1].second.energy.total());
  EXPECT_EQ(all[0].second.gradient, all[1].second.gradient);
  EXPECT_EQ(all[0].graph_start, all[1].graph_start);
  EXPECT_EQ(all[0].graph, all[1].graph);
  EXPECT_EQ(all[0].hessian, all[1].hessian);
  EXPECT_EQ(all[0].product, all[1].product);
  EXPECT_EQ(all[0].bound, all[1].bound);
}

INSTANTIATE_TEST_SUITE_P(InOrderAndScattered, SharedObjective, testing::Bool());

}  // namespace
}  // namespace foldless
