// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/rest_cover.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/core/motion/remeshed_frames.h"

namespace foldless {
namespace {

/// A square of two triangles, and the frame's, cut along the other diagonal.
class CoveredSquare : public testing::Test {
 protected:
  CoveredSquare() {
    original_.resize(3, 2);
    original_ << 0, 0, 1, 2, 2, 3;
    Triangles flipped(3, 2);
    flipped << 0, 1, 1, 2, 3, 3;
    Points rest(2, 4);
    rest << 0, 1, 1, 0, 0, 0, 1, 1;
    frame_ = *test::snapshot_of(MeshPair(flipped, rest, rest), 4);
  }

  Triangles original_;
  Snapshot frame_;
};

TEST_F(CoveredSquare, ATriangleIsCoveredByBothThatShareAreaWithIt) {
  const RestCover cover(frame_, original_);
  for (const int t : {0, 1, 0}) EXPECT_EQ(cover.covering(t).size(), 2U) << t;
}

TEST_F(CoveredSquare, ATriangleIsCoveredByItselfAlone) {
  frame_.triangles = std::make_shared<const Triangles>(original_);
  const RestCover cover(frame_, original_);
  for (const int t : {0, 1, 0}) {
    const auto covering = cover.covering(t);
    EXPECT_EQ(std::vector<int>(covering.begin(), covering.end()), std::vector<int>{t});
  }
}

TEST_F(CoveredSquare, IsOfTheFramesThatShareTrianglesAndRest) {
  const RestCover cover(frame_, original_);
  Snapshot other = frame_;
  other.deformed *= 2;
  EXPECT_TRUE(cover.is_of(other));
  other.rest = std::make_shared<const Points>(2 * *frame_.rest);
  EXPECT_FALSE(cover.is_of(other)) << "its vertices lie elsewhere";
  other.rest = frame_.rest;
  other.triangles = std::make_shared<const Triangles>(original_);
  EXPECT_FALSE(cover.is_of(other)) << "it has other triangles";
}

}  // namespace
}  // namespace foldless
