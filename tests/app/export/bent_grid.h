// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "app/export/gltf.h"
#include "tests/support/meshes.h"

namespace foldless::test {

/// A grid on [0, 3]² that bends to the right, in four frames that are not evenly spaced.
inline BakedAnimation grid_that_bends(bool loops) {
  const Fixture f = square_grid(4);
  BakedAnimation animation;
  animation.triangles = f.triangles;
  animation.rest = f.rest;
  animation.loops = loops;
  animation.cycle_frames = 4;
  animation.fps = 10;
  for (const double frame : {0.0, 1.0, 1.5, 3.0}) {
    Points bent = f.rest;
    bent.row(0) += (0.3 * (frame + 0.1) * f.rest.row(1).array().sin()).matrix();
    animation.frames.push_back({frame, bent});
  }
  return animation;
}

/// A picture on [-1, 4] × [0, 5].
inline std::vector<GltfPiece> one_piece(const BakedAnimation& animation) {
  GltfPiece piece;
  for (int t = 0; t < animation.triangles.cols(); ++t) piece.triangles.push_back(t);
  piece.image = Image(3, 2);
  std::ranges::fill(piece.image.pixels, std::uint8_t{200});
  piece.place = {{-1, 0}, {4, 5}};
  return {piece};
}

}  // namespace foldless::test
