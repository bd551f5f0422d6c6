// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/relax_patches.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/boundary.h"
#include "core/mesh/generate.h"
#include "core/mesh/patches.h"
#include "core/method/foldless/flipping_descent.h"
#include "tests/core/method/foldless/workspaces.h"
#include "tests/support/random_vector.h"
#include "tests/support/valid_pair.h"

namespace foldless {
namespace {

using test::OwnWorkspace;

constexpr int kSide = 60;

/// Marked vertices anywhere in the kernels of the triangles round them.
void shake(MeshPair& mesh, const std::vector<bool>& is_marked, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const EnergySettings energy = test::run_settings(find_density("arap"), mesh).energy;
  const Objective objective(mesh, {});
  Points step = Points::Zero(2, mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!is_marked[static_cast<std::size_t>(v)]) continue;
    step.col(v) = 0.1 * test::random_vector(unit, random);
    const double largest = objective.largest_step(energy, mesh.deformed(), step);
    mesh.set_deformed(mesh.deformed() + std::min(1.0, 0.9 * largest) * step);
    step.col(v).setZero();
  }
}

/// A square whose vertices are shaken in three spots: one inside, one at a handle, one at the
/// boundary.
struct Spots {
  explicit Spots(std::uint64_t seed) : own(workspace()) {
    std::vector<bool> near = marks({at(15, 15), at(45, 30), at(30, 2)});
    grow(near, own.work.mesh.triangles(), 2);
    shake(own.work.mesh, near, seed);
    for (Eigen::Index t = 0; t < own.work.mesh.triangles().cols(); ++t)
      for (const int v : own.work.mesh.triangles().col(t))
        if (near[static_cast<std::size_t>(v)]) {
          triangles.push_back(static_cast<int>(t));
          break;
        }
    energy = own.work.held_energy();
  }

  static int at(int column, int row) { return (kSide + 1) * row + column; }
  static std::vector<bool> marks(const std::vector<int>& vertices) {
    std::vector<bool> marks((kSide + 1) * (kSide + 1));
    for (const int v : vertices) marks[static_cast<std::size_t>(v)] = true;
    return marks;
  }
  static OwnWorkspace workspace() {
    const Shape shape = grid({.columns = kSide, .rows = kSide});
    const int held = at(45, 30), soft = at(15, 16);
    return test::workspace_of(MeshPair(shape.triangles, shape.rest),
                              {{.id = 1, .vertex = held, .target = shape.rest.col(held)},
                               {.id = 2,
                                .vertex = soft,
                                .target = shape.rest.col(soft) + Vec2(0.01, 0),
                                .kind = HandleKind::soft,
                                .weight = 1e-4}});
  }
  double value() const {
    return own.work.system.objective().value(energy, own.work.mesh.deformed()).total();
  }

  OwnWorkspace own;
  std::vector<int> triangles;
  Energy energy;
};

TEST(RelaxPatches, LowersEAndMovesNothingElse) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Spots spots(seed);
    Workspace& work = spots.own.work;
    const Points before = work.mesh.deformed();
    const double E = spots.value();
    relax_patches(work, spots.energy, spots.triangles, {});
    EXPECT_LT(spots.value(), 0.8 * E);
    EXPECT_TRUE(test::is_valid(work.mesh));
    std::vector<bool> near(static_cast<std::size_t>(work.mesh.vertex_count()));
    for (const int t : spots.triangles)
      for (const int v : work.mesh.triangles().col(t)) near[static_cast<std::size_t>(v)] = true;
    grow(near, work.mesh.triangles(), 8);
    const auto boundary = boundary_neighbours(work.mesh.triangles(), work.mesh.vertex_count());
    int moved = 0;
    for (int v = 0; v < work.mesh.vertex_count(); ++v) {
      const bool may_move = near[static_cast<std::size_t>(v)] &&
                            !boundary[static_cast<std::size_t>(v)].are_there() &&
                            v != Spots::at(45, 30);
      const bool has_moved = work.mesh.deformed().col(v) != before.col(v);
      EXPECT_TRUE(may_move || !has_moved) << "vertex " << v;
      moved += has_moved;
    }
    EXPECT_GT(moved, 300);
  }
}

TEST(RelaxPatches, EndsWhereNewtonsMethodWithTheRestHeldEnds) {
  Spots spots(4);
  Workspace& work = spots.own.work;
  for (int call = 0; call < 5; ++call) relax_patches(work, spots.energy, spots.triangles, {});
  const auto gradient =
      work.system.objective().gradient(spots.energy, work.mesh.deformed()).gradient;
  const Points column = gradient.reshaped(2, gradient.size() / 2);
  EXPECT_LT(column.col(Spots::at(15, 15)).norm(), 1e-6);
  EXPECT_LT(column.col(Spots::at(15, 16)).norm(), 1e-6) << "its soft handle pulls";
}

TEST(RelaxPatches, KeepsAValidMeshWhenCancelled) {
  Spots spots(2);
  const Points before = spots.own.work.mesh.deformed();
  std::stop_source source;
  source.request_stop();
  relax_patches(spots.own.work, spots.energy, spots.triangles, source.get_token());
  EXPECT_EQ(spots.own.work.mesh.deformed(), before);
}

TEST(RelaxPatches, LeavesPatchesThatAreMostOfTheMesh) {
  Spots spots(2);
  const Points before = spots.own.work.mesh.deformed();
  std::vector<int> all(static_cast<std::size_t>(spots.own.work.mesh.face_count()));
  std::iota(all.begin(), all.end(), 0);
  relax_patches(spots.own.work, spots.energy, all, {});
  EXPECT_EQ(spots.own.work.mesh.deformed(), before);
}

/// A large square, shaken in a spot.
OwnWorkspace large_square() {
  constexpr int kLargeSide = 141;
  const Shape shape = grid({.columns = kLargeSide, .rows = kLargeSide});
  MeshPair mesh(shape.triangles, shape.rest);
  std::vector<bool> near(static_cast<std::size_t>(mesh.vertex_count()));
  near[static_cast<std::size_t>(mesh.vertex_count() / 2)] = true;
  grow(near, mesh.triangles(), 8);
  for (const std::uint64_t seed : {1U, 2U, 3U}) shake(mesh, near, seed);
  return test::workspace_of(mesh, {{.vertex = 0, .target = shape.rest.col(0)}});
}

TEST(FlippingDescent, SeesToWhatIsInTheWayOfALargeMeshByItself) {
  OwnWorkspace plain = large_square(), own = large_square();
  ASSERT_TRUE(own.work.is_large());
  const Energy energy = own.work.held_energy();
  Descent descent;
  descent.step(plain.work.system, plain.work.mesh, energy, {});
  FlippingDescent flipping(FactorUse::lagged);
  const VertexUpdate update = flipping.step(own.work, energy, {});
  ASSERT_LT(update.step_length, 0.5);
  ASSERT_GT(update.step_length, 0);
  const auto left = [&](const Workspace& work) {
    return work.system.objective().value(energy, work.mesh.deformed()).total();
  };
  EXPECT_LT(left(own.work), 0.7 * left(plain.work));
  EXPECT_TRUE(test::is_valid(own.work.mesh));
}

}  // namespace
}  // namespace foldless
