// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/snapshot.h"

namespace foldless {

/// Which triangles of a frame's mesh share area at rest with those of the original mesh. What is
/// found is kept, in few bytes a triangle: frames of one mesh should have one of these.
/// Not thread-safe.
class RestCover {
 public:
  /// Of the mesh of a snapshot. `original`: 3 × #F, which has to outlive it.
  RestCover(const Snapshot& snapshot, const Triangles& original);

  /// Whether it is of the very mesh that the snapshot has.
  bool is_of(const Snapshot& snapshot) const {
    return triangles_ == snapshot.triangles && rest_ == snapshot.rest;
  }
  /// The frame's triangles that share area at rest with an original one.
  std::span<const int> covering(int triangle) const;

 private:
  std::vector<int> find_covering(int triangle) const;
  std::vector<int> neighbours(int triangle) const;

  std::shared_ptr<const Triangles> triangles_;
  std::shared_ptr<const Points> rest_;
  const Triangles& original_;
  std::vector<int> first_;  ///< of a vertex in `round_`, #V + 1
  std::vector<int> round_;  ///< triangles by vertex
  /// By original triangle: the one that covers it, or what of it is known.
  mutable std::vector<int> alone_;
  mutable std::unordered_map<int, std::vector<int>> several_;
};

}  // namespace foldless
