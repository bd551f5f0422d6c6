// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/rest_cover.h"

#include <set>

#include "core/motion/corners.h"

namespace foldless {
namespace {

/// Finds what covers a triangle along the edges of a frame's mesh.
class CoverSearch {
 public:
  explicit CoverSearch(const Snapshot& snapshot)
      : triangles_(*snapshot.triangles), rest_(*snapshot.rest) {
    first_.assign(static_cast<std::size_t>(rest_.cols()) + 1, 0);
    for (const int v : triangles_.reshaped()) ++first_[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    round_.resize(static_cast<std::size_t>(triangles_.size()));
    for (Eigen::Index t = 0; t < triangles_.cols(); ++t)
      for (const int v : triangles_.col(t))
        round_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<int>(t);
  }

  /// Of an original triangle, whose corners the frame's mesh has too.
  std::vector<int> covering(const Eigen::Vector3i& corners) const {
    const Corners covered = corners_of(rest_, corners);
    std::vector<int> found;
    std::set<int> seen;
    const auto visit = [&](int t) {
      if (seen.insert(t).second && share_area(corners_of(rest_, triangles_.col(t)), covered))
        found.push_back(t);
    };
    for (const int t : round(corners[0])) visit(t);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const int t : neighbours(found[i])) visit(t);
    return found;
  }

 private:
  std::span<const int> round(int v) const {
    const auto first = static_cast<std::size_t>(first_[static_cast<std::size_t>(v)]);
    const auto end = static_cast<std::size_t>(first_[static_cast<std::size_t>(v) + 1]);
    return std::span(round_).subspan(first, end - first);
  }

  std::vector<int> neighbours(int triangle) const {
    const Eigen::Vector3i corners = triangles_.col(triangle);
    std::vector<int> result;
    for (const int v : corners)
      for (const int other : round(v)) {
        int common = 0;
        for (const int w : triangles_.col(other)) common += (corners.array() == w).any() ? 1 : 0;
        if (common == 2) result.push_back(other);
      }
    return result;
  }

  const Triangles& triangles_;
  const Points& rest_;
  std::vector<int> first_;  ///< of a vertex in `round_`, #V + 1
  std::vector<int> round_;  ///< triangles by vertex
};

}  // namespace

RestCover::RestCover(const Snapshot& snapshot, const Triangles& original)
    : triangles_(snapshot.triangles), rest_(snapshot.rest), first_{0} {
  const CoverSearch search(snapshot);
  first_.reserve(static_cast<std::size_t>(original.cols()) + 1);
  for (Eigen::Index t = 0; t < original.cols(); ++t) {
    const std::vector<int> found = search.covering(original.col(t));
    covering_.insert(covering_.end(), found.begin(), found.end());
    first_.push_back(static_cast<unsigned>(covering_.size()));
  }
  covering_.shrink_to_fit();
}

}  // namespace foldless
