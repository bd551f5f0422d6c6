// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/shared_elements.h"

#include <numeric>

namespace foldless {

void CornersOfVertices::assign(const Triangles& triangles, std::size_t vertices) {
  start_.assign(vertices + 1, 0);
  for (const int v : triangles.reshaped()) ++start_[static_cast<std::size_t>(v) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  corners_.resize(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      corners_[start_[static_cast<std::size_t>(triangles(corner, t))]++] = {static_cast<int>(t),
                                                                            corner};
  // Every start has moved on to the end of its vertex, which is where the next begins.
  for (std::size_t v = vertices; v > 0; --v) start_[v] = start_[v - 1];
  start_[0] = 0;
}

}  // namespace foldless
