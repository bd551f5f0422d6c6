// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/adopted_pose.h"

namespace foldless {
namespace {

template <class T>
bool is_equal(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && a->cols() == b->cols() && *a == *b);
}

template <typename Array>
std::size_t bytes_of(const Array& array) {
  return static_cast<std::size_t>(array.size()) * sizeof(*array.data());
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

std::size_t added_bytes(const Snapshot& snapshot, const Snapshot* before) {
  std::size_t bytes = sizeof(Snapshot) + bytes_of(snapshot.deformed) + bytes_of(snapshot.handles);
  if (!before || before->triangles != snapshot.triangles) bytes += bytes_of(*snapshot.triangles);
  if (!before || before->rest != snapshot.rest) bytes += bytes_of(*snapshot.rest);
  if (!before || before->flipped_edges != snapshot.flipped_edges)
    bytes += bytes_of(*snapshot.flipped_edges);
  return bytes;
}

}  // namespace foldless
