// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/other_ways.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/method/foldless/transport_plans.h"
#include "tests/core/method/foldless/held_frame.h"

namespace foldless {
namespace {

constexpr std::size_t kRandomOrdersOfOtherWays = 16;

EnergySettings energy_of(const Workspace& workspace) {
  return workspace.system.objective().settings();
}

std::size_t first_plans(const Workspace& workspace) {
  const Points starts = held_where_they_are(workspace.constraints, workspace.mesh.deformed()).targets;
  return transport_plans(starts, workspace.constraints.targets, 0).size();
}

/// The numbers of triangles that the ways begin with.
std::vector<int> faces_of_all(OtherWays& ways, const Workspace& workspace) {
  std::vector<int> faces;
  while (const std::optional<Attempt> way = ways.next(workspace))
    faces.push_back(way->work.mesh.face_count());
  return faces;
}

TEST(OtherWays, BeginWithAnApproachWhereNoneBeganAtRest) {
  const Workspace workspace = test::held_frame(1);
  OtherWays after_rest(energy_of(workspace), false), after_a_drag(energy_of(workspace), true);
  EXPECT_TRUE(after_rest.next(workspace)->is_transport());
  EXPECT_FALSE(after_a_drag.next(workspace)->is_transport());
  EXPECT_TRUE(after_a_drag.next(workspace)->is_transport());
  EXPECT_EQ(after_a_drag.count(), 2);
}

TEST(OtherWays, EndWithEveryTransportOnARefinedMesh) {
  const Workspace workspace = test::held_frame(1);
  OtherWays ways(energy_of(workspace), false);
  const std::vector<int> faces = faces_of_all(ways, workspace);
  const std::size_t half = first_plans(workspace) + kRandomOrdersOfOtherWays;
  ASSERT_EQ(faces.size(), 2 * half);
  for (std::size_t i = 0; i < half; ++i) EXPECT_EQ(faces[i], workspace.mesh.face_count());
  for (std::size_t i = half; i < faces.size(); ++i)
    EXPECT_GT(faces[i], 3 * workspace.mesh.face_count());
}

TEST(OtherWays, GoOnFromTheNearestLockAfterTheFirstTransports) {
  const Workspace workspace = test::held_frame(1);
  OtherWays ways(energy_of(workspace), false);
  for (std::size_t i = 0; i < first_plans(workspace); ++i) ways.next(workspace);
  const Workspace& far = workspace;
  Workspace near = workspace;
  near.split_edges({{24, Vec2(1, 0)}});  // to tell it from the other
  ASSERT_GT(near.mesh.face_count(), far.mesh.face_count());
  near.constraints.targets = 0.9 * near.constraints.targets +
                           0.1 * held_where_they_are(far.constraints, far.mesh.deformed()).targets;
  ASSERT_LT(near.error(), far.error());
  ways.take_locked(near);
  ways.take_locked(far);
  EXPECT_EQ(ways.next(workspace)->work.mesh.face_count(), near.mesh.face_count());
  EXPECT_GT(ways.next(workspace)->work.mesh.face_count(), 3 * near.mesh.face_count());
  EXPECT_EQ(ways.next(workspace)->work.mesh.face_count(), workspace.mesh.face_count());
}

TEST(OtherWays, CountWhatWasSpentBefore) {
  Workspace workspace = test::held_frame(1);
  OtherWays ways(energy_of(workspace), false);
  for (std::size_t i = 0; i < first_plans(workspace); ++i) ways.next(workspace);
  ways.take_locked(workspace);
  workspace.system.counters.factorizations = 77;
  EXPECT_EQ(ways.next(workspace)->work.system.counters.factorizations, 77);
}

}  // namespace
}  // namespace foldless
