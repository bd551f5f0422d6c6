// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/adopted_pose.h"

namespace foldless {
namespace {

template <class T>
bool is_equal(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && a->cols() == b->cols() && *a == *b);
}

}  // namespace

std::shared_ptr<const Snapshot> adopted_pose(const std::shared_ptr<const Snapshot>& snapshot,
                                             const Snapshot& previous) {
  const bool same_triangles = is_equal(snapshot->triangles, previous.triangles);
  const bool same_rest = is_equal(snapshot->rest, previous.rest);
  auto pose = std::make_shared<Snapshot>(*snapshot);
  if (same_rest) pose->rest = previous.rest;
  if (same_triangles) {
    pose->triangles = previous.triangles;
    pose->flipped_edges = previous.flipped_edges;
  }
  if (same_triangles && same_rest) pose->revision = previous.revision;
  return pose;
}

}  // namespace foldless
