// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shape.h"

namespace foldless {

void append(const Shape& part, Shape& whole) {
  const auto vertices = whole.rest.cols();
  const auto faces = whole.triangles.cols();
  whole.rest.conservativeResize(2, vertices + part.rest.cols());
  whole.rest.rightCols(part.rest.cols()) = part.rest;
  whole.triangles.conservativeResize(3, faces + part.triangles.cols());
  whole.triangles.rightCols(part.triangles.cols()) =
      part.triangles.array().matrix() +
      Triangles::Constant(3, part.triangles.cols(), static_cast<int>(vertices));
}

}  // namespace foldless
