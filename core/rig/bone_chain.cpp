// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rig/bone_chain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace foldless {
namespace {

/// In parts of the length of all bones: less than that off a line is in one line.
constexpr double kFlat = 1e-3;
/// Of FABRIK; what is left of the way is closed exactly.
constexpr double kNear = 1e-9;
constexpr int kMostRounds = 500, kMostRoundsOfAStep = 10;
/// The end goes to its target in steps of this length, so that it takes no leap to another of the
/// shapes that get there.
constexpr double kStep = 1.0 / 64;

Eigen::VectorXd lengths_of(const Points& joints) {
  const Eigen::Index bones = joints.cols() - 1;
  return (joints.rightCols(bones) - joints.leftCols(bones)).colwise().norm().transpose();
}

Vec2 unit_or(const Vec2& v, const Vec2& otherwise) {
  const double length = v.norm();
  return length > 0 ? Vec2(v / length) : otherwise;
}

/// The rotation that takes one direction to another; none where either has no length.
Mat2 rotation(const Vec2& from, const Vec2& to) {
  const Vec2 turn = unit_or({from.dot(to), cross(from, to)}, {1, 0});
  return Mat2{{turn.x(), -turn.y()}, {turn.y(), turn.x()}};
}

/// All bones in their directions, as long as they should be.
Points with_lengths(const Points& joints, const Eigen::VectorXd& lengths) {
  Points result = joints;
  Vec2 along(1, 0);
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    along = unit_or(joints.col(i + 1) - joints.col(i), along);
    result.col(i + 1) = result.col(i) + lengths[i] * along;
  }
  return result;
}

/// A turn about a point, which comes to another.
struct RigidMotion {
  Vec2 from, to;
  Mat2 turn;
};

/// Moves the joints from `first` on.
void carry(Points& joints, Eigen::Index first, const RigidMotion& motion) {
  for (Eigen::Index i = first; i < joints.cols(); ++i)
    joints.col(i) = motion.to + motion.turn * (joints.col(i) - motion.from);
}

/// A section of a chain that its last joint is moved of: where it begins, how long its bones are,
/// and where the joint should be.
struct Reach {
  Vec2 root;
  Eigen::VectorXd lengths;
  Vec2 target;
  Vec2 direction;  ///< from the root to the target, of length 1
  double distance = 0;
  double whole = 0;  ///< length of all bones
};

Points in_line(const Reach& reach, const Eigen::VectorXd& signed_lengths) {
  Points joints(2, signed_lengths.size() + 1);
  joints.col(0) = reach.root;
  for (Eigen::Index i = 0; i < signed_lengths.size(); ++i)
    joints.col(i + 1) = joints.col(i) + signed_lengths[i] * reach.direction;
  return joints;
}

/// Brings the end to the target: what lies before the joint m and what lies behind it are two stiff
/// bones, a triangle with the way to the target up to rounding.
void close_at(Points& joints, Eigen::Index m, const Reach& reach) {
  const Eigen::Index end = joints.cols() - 1;
  const Vec2 elbow = joints.col(m), hand = joints.col(end);
  const double a = (elbow - reach.root).norm(), b = (hand - elbow).norm();
  const double d = reach.distance;
  const double along = d > 0 ? std::clamp((d + (a - b) * (a + b) / d) / 2, -a, a) : 0;
  const double height = std::sqrt(std::max(0.0, (a - along) * (a + along)));
  const double side = cross(hand - reach.root, elbow - reach.root) < 0 ? -1 : 1;
  const Vec2 across(-reach.direction.y(), reach.direction.x());
  const Vec2 bent = reach.root + along * reach.direction + side * height * across;
  const Mat2 first = rotation(elbow - reach.root, bent - reach.root);
  const Mat2 second = rotation(hand - elbow, reach.target - bent);
  for (Eigen::Index i = 1; i < m; ++i)
    joints.col(i) = reach.root + first * (joints.col(i) - reach.root);
  joints.col(m) = reach.root + first * (elbow - reach.root);
  const Vec2 now = joints.col(m);
  carry(joints, m + 1, {elbow, now, second});
}

/// Closes what FABRIK leaves, at the joint that has the most to spare.
void close(Points& joints, const Reach& reach) {
  const Eigen::Index end = joints.cols() - 1;
  Eigen::Index best = 1;
  double most = -reach.whole;
  for (Eigen::Index m = 1; m < end; ++m) {
    const double a = (joints.col(m) - reach.root).norm();
    const double b = (joints.col(end) - joints.col(m)).norm();
    const double spare = std::min(a + b - reach.distance, reach.distance - std::abs(a - b));
    if (spare <= most) continue;
    most = spare;
    best = m;
  }
  close_at(joints, best, reach);
}

/// Forward and backward reaching inverse kinematics [AL11].
void fabrik(Points& joints, const Reach& reach, int most_rounds) {
  const Eigen::Index end = joints.cols() - 1;
  for (int round = 0; round < most_rounds; ++round) {
    if ((joints.col(end) - reach.target).norm() <= kNear * reach.whole) return;
    joints.col(end) = reach.target;
    for (Eigen::Index i = end; i-- > 0;)
      joints.col(i) =
          joints.col(i + 1) +
          reach.lengths[i] * unit_or(joints.col(i) - joints.col(i + 1), -reach.direction);
    joints.col(0) = reach.root;
    for (Eigen::Index i = 0; i < end; ++i)
      joints.col(i + 1) =
          joints.col(i) +
          reach.lengths[i] * unit_or(joints.col(i + 1) - joints.col(i), reach.direction);
  }
}

/// The same with the end moved there step by step. It begins in the direction of the target.
void walk(Points& joints, const Reach& reach) {
  const Eigen::Index end = joints.cols() - 1;
  const double from = (joints.col(end) - reach.root).dot(reach.direction);
  const double step = reach.distance < from ? -kStep : kStep;
  Reach next = reach;
  for (double d = from + step * reach.whole; (reach.distance - d) * step > 0;
       d += step * reach.whole) {
    next.target = reach.root + d * reach.direction;
    fabrik(joints, next, kMostRoundsOfAStep);
  }
  fabrik(joints, reach, kMostRounds);
}

/// How far the joints are off the line through their root that comes nearest to them, about.
double height_of(const Points& joints) {
  const Points from_root = joints.colwise() - joints.col(0);
  Eigen::Index farthest = 0;
  const double reach = from_root.colwise().norm().maxCoeff(&farthest);
  if (reach == 0) return 0;
  const Vec2 along = from_root.col(farthest) / reach;
  double height = 0;
  for (const auto& p : from_root.colwise()) height = std::max(height, std::abs(cross(along, p)));
  return height;
}

/// Every bone turned a little less to the left than the one before, so that a line becomes a bow.
Points bow_of(const Points& joints, const Eigen::VectorXd& lengths) {
  Points bow = joints;
  const Eigen::Index bones = lengths.size();
  for (Eigen::Index i = 0; i < bones; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(bones);
    const Eigen::Rotation2D<double> turn(std::numbers::pi / 6 * (1 - 2 * part));
    bow.col(i + 1) = bow.col(i) + turn * (joints.col(i + 1) - joints.col(i));
  }
  return bow;
}

/// What FABRIK begins with, at the root of `reach` and towards its target.
Points seed_of(const BoneChain& section, const Reach& reach) {
  Points seed = section.joints;
  const double flat = kFlat * reach.whole;
  if (height_of(seed) < flat) seed = section.rest;
  if (height_of(seed) < flat) seed = bow_of(seed, reach.lengths);
  const Vec2 root = seed.col(0);
  const Vec2 way = seed.col(seed.cols() - 1) - root;
  const bool has_direction = way.norm() > kNear * reach.whole;
  const Mat2 turn = has_direction ? rotation(way, reach.direction) : Mat2(Mat2::Identity());
  carry(seed, 0, {root, reach.root, turn});
  return seed;
}

/// The joints of a section, the last of which should be at a target. Bones have their lengths.
Points reaching(const BoneChain& section, const Eigen::VectorXd& lengths, const Vec2& target) {
  const Eigen::Index end = section.joints.cols() - 1;
  const Vec2 root = section.joints.col(0), hand = section.joints.col(end);
  if (hand == target) return section.joints;
  Reach reach{root, lengths, target, {}, (target - root).norm(), lengths.sum()};
  reach.direction = unit_or(target - root, unit_or(hand - root, {1, 0}));
  Eigen::Index longest = 0;
  const double others = reach.whole - lengths.maxCoeff(&longest);
  if (reach.distance >= reach.whole) return in_line(reach, lengths);
  if (reach.distance <= lengths[longest] - others) {  // nearer to the root than it can bend
    Eigen::VectorXd folded = -lengths;
    folded[longest] = lengths[longest];
    return in_line(reach, folded);
  }
  Points joints = seed_of(section, reach);
  if (end > 2) walk(joints, reach);
  close(joints, reach);
  return joints;
}

}  // namespace

Points with_moved_joints(const BoneChain& chain, std::span<const MovedJoint> moved) {
  const Eigen::VectorXd lengths = lengths_of(chain.rest);
  Points joints = with_lengths(chain.joints, lengths);
  Eigen::Index anchor = 0;
  for (const auto& [joint, to] : moved) {
    if (joint == 0) {
      joints.colwise() += Vec2(to - joints.col(0));
      continue;
    }
    const Eigen::Index count = joint - anchor + 1;
    const BoneChain section{chain.rest.middleCols(anchor, count), joints.middleCols(anchor, count)};
    const Points solved = reaching(section, lengths.segment(anchor, count - 1), to);
    const Vec2 before = joints.col(joint), bone = before - joints.col(joint - 1);
    joints.middleCols(anchor, count) = solved;
    const Vec2 after = joints.col(joint);
    const Mat2 turn = rotation(bone, after - joints.col(joint - 1));
    carry(joints, joint + 1, {before, after, turn});
    anchor = joint;
  }
  return joints;
}

}  // namespace foldless
