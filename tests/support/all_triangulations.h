// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless::test {

using Pieces = std::vector<Eigen::Vector3i>;

/// All triangulations, one after the other, of a polygon on its corners i, i + 1, …, k alone.
inline std::vector<Pieces> all_triangulations(int i, int k) {
  if (k - i < 2) return {{}};
  std::vector<Pieces> all;
  for (int j = i + 1; j < k; ++j)
    for (const Pieces& left : all_triangulations(i, j))
      for (const Pieces& right : all_triangulations(j, k)) {
        Pieces& pieces = all.emplace_back(left);
        pieces.insert(pieces.end(), right.begin(), right.end());
        pieces.emplace_back(i, j, k);
      }
  return all;
}

inline Triangles as_triangles(const Pieces& pieces) {
  Triangles triangles(3, static_cast<Eigen::Index>(pieces.size()));
  for (std::size_t t = 0; t < pieces.size(); ++t)
    triangles.col(static_cast<Eigen::Index>(t)) = pieces[t];
  return triangles;
}

}  // namespace foldless::test
