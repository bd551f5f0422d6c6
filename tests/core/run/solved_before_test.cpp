// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/solved_before.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

using SharedSnapshot = std::shared_ptr<const Snapshot>;

/// One vertex at (x, x), or so many of them.
SharedSnapshot pose_at(double x, int vertices = 1) {
  static const auto triangles = std::make_shared<const Triangles>(3, 0);
  static const auto no_edges = std::make_shared<const std::vector<Edge>>();
  auto made = std::make_shared<Snapshot>();
  made->triangles = triangles;
  made->flipped_edges = no_edges;
  made->rest = std::make_shared<const Points>(Points::Zero(2, vertices));
  made->deformed = Points::Constant(2, vertices, x);
  return made;
}

TEST(SolvedBefore, KnowsAFrameByAllThatItFollowsFrom) {
  SolvedBefore solved;
  const std::vector<Handle> here(1);
  std::vector<Handle> there(1);
  there[0].target = {1, 0};
  const SolvedFrame frame{3, pose_at(5), true, ""};
  solved.add(pose_at(4), here, frame);
  ASSERT_TRUE(solved.find(3, pose_at(4).get(), here)) << "another object with the same bits";
  EXPECT_EQ(solved.find(3, pose_at(4).get(), here)->snapshot, frame.snapshot);
  EXPECT_FALSE(solved.find(3, pose_at(4).get(), there));
  EXPECT_FALSE(solved.find(3, pose_at(4.5).get(), here));
  EXPECT_FALSE(solved.find(3, nullptr, here));
  EXPECT_FALSE(solved.find(2, pose_at(4).get(), here));
}

TEST(SolvedBefore, LosesWhatWasAddedFirstWhereAllWouldTakeTooMuchMemory) {
  constexpr int kVertices = 1000;  // 32 kB a frame, as none shares its mesh at rest with another
  SolvedBefore solved(100'000);
  const std::vector<Handle> handles(1);
  const auto is_known = [&](int i) { return solved.find(i % 5, pose_at(i).get(), handles); };
  std::weak_ptr<const Snapshot> first;
  for (int i = 0; i < 20; ++i) {
    const SharedSnapshot frame = pose_at(i + 1, kVertices);
    if (i == 0) first = frame;
    solved.add(pose_at(i), handles, {static_cast<double>(i % 5), frame, true, ""});
    EXPECT_TRUE(is_known(i)) << i;
  }
  EXPECT_TRUE(first.expired()) << "nothing holds it any more";
  for (int i = 0; i < 17; ++i) EXPECT_FALSE(is_known(i)) << i;
  for (int i = 17; i < 20; ++i) EXPECT_TRUE(is_known(i)) << i;
  solved.add(nullptr, handles, {7, pose_at(0, 10 * kVertices), true, ""});
  EXPECT_FALSE(solved.find(7, nullptr, handles)) << "it does not fit by itself";
  solved.add(pose_at(0), handles, {7, pose_at(1), true, ""});
  EXPECT_TRUE(solved.find(7, pose_at(0).get(), handles)) << "but others do";
}

}  // namespace
}  // namespace foldless
