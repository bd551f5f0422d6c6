// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/rest_cover.h"

#include <set>
#include <utility>

#include "core/motion/corners.h"

namespace foldless {
namespace {

constexpr int kUnknown = -1, kSeveral = -2;

}  // namespace

RestCover::RestCover(const Snapshot& snapshot, const Triangles& original)
    : triangles_(snapshot.triangles),
      rest_(snapshot.rest),
      original_(original),
      alone_(static_cast<std::size_t>(original.cols()), kUnknown) {
  const Triangles& triangles = *triangles_;
  first_.assign(static_cast<std::size_t>(rest_->cols()) + 1, 0);
  for (const int v : triangles.reshaped()) ++first_[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  round_.resize(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (const int v : triangles.col(t))
      round_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = static_cast<int>(t);
}

std::vector<int> RestCover::neighbours(int triangle) const {
  const Triangles& triangles = *triangles_;
  const Eigen::Vector3i corners = triangles.col(triangle);
  std::vector<int> result;
  for (const int v : corners)
    for (int k = first_[static_cast<std::size_t>(v)]; k < first_[static_cast<std::size_t>(v) + 1];
         ++k) {
      const int other = round_[static_cast<std::size_t>(k)];
      int common = 0;
      for (const int w : triangles.col(other)) common += (corners.array() == w).any() ? 1 : 0;
      if (common == 2) result.push_back(other);
    }
  return result;
}

std::vector<int> RestCover::find_covering(int triangle) const {
  const Points& rest = *rest_;
  const Eigen::Vector3i corners = original_.col(triangle);
  const Corners covered = corners_of(rest, corners);
  const auto covers = [&](int t) {
    return share_area(corners_of(rest, triangles_->col(t)), covered);
  };
  std::vector<int> found;
  std::set<int> seen;
  const auto visit = [&](int t) {
    if (seen.insert(t).second && covers(t)) found.push_back(t);
  };
  const auto corner = static_cast<std::size_t>(corners[0]);
  for (int k = first_[corner]; k < first_[corner + 1]; ++k)
    visit(round_[static_cast<std::size_t>(k)]);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const int t : neighbours(found[i])) visit(t);
  return found;
}

std::span<const int> RestCover::covering(int triangle) const {
  int& alone = alone_[static_cast<std::size_t>(triangle)];
  if (alone == kUnknown) {
    std::vector<int> found = find_covering(triangle);
    alone = found.size() == 1 ? found.front() : kSeveral;
    if (alone == kSeveral) several_[triangle] = std::move(found);
  }
  if (alone == kSeveral) return several_.at(triangle);
  return {&alone, 1};
}

}  // namespace foldless
