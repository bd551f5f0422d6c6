// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/mesh/triangle.h"

namespace foldless {

/// The joints of a chain of bones, root first, 2 × two or more, as they are at rest and now. A bone
/// goes from a joint to the next and is as long as at rest. [length]
struct BoneChain {
  Points rest;
  Points joints;
};

/// Where a hand wants a joint.
struct MovedJoint {
  Eigen::Index joint = 0;
  Vec2 to = Vec2::Zero();
};

/// The joints after some of them, in the order of the chain, were moved. The root takes the chain
/// along. Any other joint is met by those between it and the joint that was moved before it, or
/// the root: two bones in closed form by the law of cosines, bent to the side that they are bent
/// to; more by FABRIK [AL11]; what is out of reach by a straight line towards it. Joints beyond the
/// last one follow rigidly. Lengths are kept to rounding.
///
/// A function of the chain and the hand alone, without a memory: hand there and back, all as it
/// was. Bones that lie in one line bend as they do at rest, or to the left where they are in one
/// line there too.
Points with_moved_joints(const BoneChain& chain, std::span<const MovedJoint> moved);

}  // namespace foldless
