// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// Which triangles of a frame's mesh share area at rest with those of the original mesh, in few
/// bytes a triangle: thousands of frames may each have a mesh of their own. Frames of one mesh
/// should have one of these.
class RestCover {
 public:
  /// Of the mesh of a snapshot. `original`: 3 × #F.
  RestCover(const Snapshot& snapshot, const Triangles& original);

  /// Whether it is of the very mesh that the snapshot has.
  bool is_of(const Snapshot& snapshot) const {
    return triangles_ == snapshot.triangles && rest_ == snapshot.rest;
  }
  /// The frame's triangles that share area at rest with an original one.
  std::span<const int> covering(int triangle) const {
    const auto t = static_cast<std::size_t>(triangle);
    return std::span(covering_).subspan(first_[t], first_[t + 1] - first_[t]);
  }

 private:
  std::shared_ptr<const Triangles> triangles_;
  std::shared_ptr<const Points> rest_;
  std::vector<unsigned> first_;  ///< of an original triangle in `covering_`, #F + 1
  std::vector<int> covering_;
};

}  // namespace foldless
