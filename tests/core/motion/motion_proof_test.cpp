// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/motion_proof.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "tests/support/meshes.h"

namespace foldless {
namespace {

using Place = MotionFailure::Place;

constexpr int kMoments = 16;

/// Positions that are small integers are integers at every sampled moment, kMoments times as large:
/// predicates on them are exact.
Points sample_of(const Points& from, const Points& to, int i) {
  return (kMoments - i) * from + i * to;
}

Points integers_near(const Points& points, double spread, std::mt19937& random) {
  std::uniform_real_distribution<double> offset(-spread, spread);
  return points.unaryExpr([&](double x) { return std::round(x + offset(random)); });
}

/// Every sampled moment before the failure is locally injective, and the failure is seen where it
/// is at a sample.
void expect_agreement(const test::Fixture& f, const Points& from, const Points& to) {
  const MotionProof proof(f.triangles, static_cast<int>(from.cols()));
  const auto failure = proof.first_failure(from, to);
  const InjectivityChecker checker(f.triangles, static_cast<int>(from.cols()));
  for (int i = 0; i <= kMoments; ++i) {
    const double t = static_cast<double>(i) / kMoments;
    if (failure && t > failure->moment - 1e-12) break;
    ASSERT_TRUE(checker.is_injective(sample_of(from, to, i))) << "moment " << t;
  }
}

TEST(MotionProof, AMeshThatMovesAsOneIsInjectiveAllTheTime) {
  const test::Fixture f = test::square_grid(6);
  Points to = 2.5 * f.rest;
  to.row(1).array() += 7;
  EXPECT_EQ(MotionProof(f.triangles, static_cast<int>(f.rest.cols())).first_failure(f.rest, to),
            std::nullopt);
}

TEST(MotionProof, HalfATurnCollapsesHalfWayAndAQuarterDoesNot) {
  const test::Fixture f = test::square_grid(6);
  const MotionProof proof(f.triangles, static_cast<int>(f.rest.cols()));
  const Points half = -f.rest;
  const auto failure = proof.first_failure(f.rest, half);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->place, Place::triangle);
  EXPECT_EQ(failure->moment, 0.5);
  const Points quarter = Eigen::Rotation2Dd(1.5).toRotationMatrix() * f.rest;
  EXPECT_EQ(proof.first_failure(f.rest, quarter), std::nullopt);
}

TEST(MotionProof, AFlatTriangleIsNamed) {
  const test::Fixture f = test::square_grid(5);
  Points to = f.rest;
  to.col(12) = f.rest.col(13);  // The vertex in the middle goes to its neighbour.
  const MotionProof proof(f.triangles, static_cast<int>(f.rest.cols()));
  const auto failure = proof.first_failure(f.rest, to);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->moment, 1);
  const Eigen::Vector3i t = f.triangles.col(failure->index);
  EXPECT_TRUE((t.array() == 12).any() && (t.array() == 13).any());
  EXPECT_EQ(proof.first_failure(f.rest, 0.5 * (f.rest + to)), std::nullopt);
}

TEST(MotionProof, ABoundaryThatClosesIsNamed) {
  const test::Fixture f = test::open_fan(300, 6);
  const MotionProof proof(f.triangles, static_cast<int>(f.rest.cols()));
  Points to = Eigen::Rotation2Dd(0.2).toRotationMatrix() * f.rest;
  EXPECT_EQ(proof.first_failure(f.rest, to), std::nullopt);
  const auto last = to.cols() - 1;
  to.col(last) = Eigen::Rotation2Dd(1.4).toRotationMatrix() * f.rest.col(last);
  const auto failure = proof.first_failure(f.rest, to);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->place, Place::boundary_vertex);
  EXPECT_EQ(failure->index, 0);
  EXPECT_GT(failure->moment, 0.5);
  EXPECT_LT(failure->moment, 1);
}

TEST(MotionProof, WhatIsWrongAtTheStartIsWrongAtMomentZero) {
  const test::Fixture f = test::square_grid(4);
  const MotionProof proof(f.triangles, static_cast<int>(f.rest.cols()));
  Points mirrored = f.rest;
  mirrored.row(0) *= -1;
  ASSERT_TRUE(proof.first_failure(mirrored, f.rest));
  EXPECT_EQ(*proof.first_failure(mirrored, f.rest), (MotionFailure{Place::triangle, 0, 0}));
  const test::Fixture closed = test::open_fan(365, 7);
  const MotionProof of_fan(closed.triangles, static_cast<int>(closed.rest.cols()));
  ASSERT_TRUE(of_fan.first_failure(closed.rest, closed.rest));
  EXPECT_EQ(*of_fan.first_failure(closed.rest, closed.rest),
            (MotionFailure{Place::boundary_vertex, 0, 0}));
}

/// A closed fan of triangles about vertex 0 whose rim winds round it so many times.
test::Fixture wound_fan(int turns, int rim) {
  test::Fixture f;
  f.triangles.resize(3, rim);
  f.rest.resize(2, rim + 1);
  f.rest.col(0).setZero();
  for (int k = 0; k < rim; ++k) {
    const double angle = 2 * 3.14159265358979323846 * turns * k / rim;
    f.rest.col(k + 1) = Vec2(std::cos(angle), std::sin(angle));
    f.triangles.col(k) << 0, k + 1, (k + 1) % rim + 1;
  }
  return f;
}

TEST(MotionProof, AVertexWoundTwiceIsNamedAndCannotComeOfOneWoundOnce) {
  const test::Fixture once = wound_fan(1, 9), twice = wound_fan(2, 9);
  const MotionProof proof(once.triangles, 10);
  ASSERT_TRUE(proof.first_failure(twice.rest, twice.rest));
  EXPECT_EQ(*proof.first_failure(twice.rest, twice.rest),
            (MotionFailure{Place::branch_vertex, 0, 0}));
  const auto failure = proof.first_failure(once.rest, twice.rest);
  ASSERT_TRUE(failure) << "all triangles are well at both frames";
  EXPECT_EQ(failure->place, Place::triangle);
  EXPECT_LT(failure->moment, 1);
  EXPECT_EQ(proof.first_failure(once.rest, once.rest), std::nullopt);
}

TEST(MotionProof, AgreesWithEveryMomentThatIsSampled) {
  std::mt19937 random(20141207);
  int proved = 0, only_between = 0, at_boundary = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    const double angle = std::uniform_real_distribution<double>(280, 355)(random);
    const test::Fixture f = trial % 2 == 0 ? test::square_grid(3) : test::open_fan(angle, 5);
    const double turn = std::uniform_real_distribution<double>(-3, 3)(random);
    const Points from = integers_near(20 * f.rest, 5, random);
    const Points to =
        integers_near(20 * (Eigen::Rotation2Dd(turn).toRotationMatrix() * f.rest), 5, random);
    expect_agreement(f, from, to);
    const auto failure =
        MotionProof(f.triangles, static_cast<int>(from.cols())).first_failure(from, to);
    if (!failure) ++proved;
    if (failure && is_injective(f.triangles, from) && is_injective(f.triangles, to)) ++only_between;
    if (failure && failure->place == Place::boundary_vertex && failure->moment > 0) ++at_boundary;
  }
  EXPECT_GT(proved, 300);
  EXPECT_GT(only_between, 20);
  EXPECT_GT(at_boundary, 20);
}

}  // namespace
}  // namespace foldless
