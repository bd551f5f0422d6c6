// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "app/export/placed_mesh.h"
#include "app/export/vector_file.h"
#include "app/export/vector_pane.h"
#include "render/distortion.h"
#include "render/theme.h"

namespace foldless {

/// The squares of the checkerboard that is fixed to the rest mesh.
struct VectorBoard {
  glm::vec4 light, dark;
  double squares = 20;  ///< along the longer side of the rest mesh's box
};

/// An image and where it is in the rest plane, ready to be drawn any number of times.
struct VectorImage {
  CairoSurface surface;
  int border = 0;  ///< pixels at each side that repeat the outermost ones
  Box place;       ///< of the image without its border
};

/// `image` premultiplied. Its border reaches as far as the mesh reaches out of `place`, but for a
/// mesh far out of it.
VectorImage vector_image(const Image& image, const Box& place, const Box& rest_box);
/// The same where nothing lies beyond the image, as round a layer that was cut down to what is
/// seen.
VectorImage vector_piece(const Image& image, const Box& place);

// Each fills one sheet, without seams between triangles or between sheets.

void fill_with_board(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                     const VectorBoard& board);
/// One image for the whole mesh, or one for each of its parts; one without a surface draws nothing.
void fill_with_images(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                      std::span<const VectorImage> images);
/// One colour of viridis a triangle.
void fill_with_heat(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                    const Distortion& distortion);
/// The triangles that are turned over, in one colour.
void fill_folded(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                 const glm::vec4& colour);

}  // namespace foldless
