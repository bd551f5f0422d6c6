// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/solve.h>

#include <filesystem>
#include <optional>
#include <string>

namespace foldless {

/// A mesh of what is opaque in a picture, in pixels, the lower left corner at (0, 0), y up.
struct PictureMesh {
  PointMatrix rest;          ///< #V × 2
  TriangleMatrix triangles;  ///< #F × 3
};

/// `detail`: coarse, medium or fine, about 500, 2,000 or 8,000 vertices. Throws Error.
PictureMesh mesh_of_picture(const std::filesystem::path& picture, const std::string& detail);

/// How a result is drawn.
struct DrawingOptions {
  std::string view = "both";                     ///< deformed, rest or both
  int width = 1200;                              ///< pixels
  int height = 900;                              ///< pixels
  std::optional<std::filesystem::path> texture;  ///< a picture that `rest` was meshed from
};

/// Draws a result into a file whose name ends with .png, .svg or .pdf. Throws Error.
void draw(const Result& result, const std::filesystem::path& picture, const DrawingOptions& how);

}  // namespace foldless
