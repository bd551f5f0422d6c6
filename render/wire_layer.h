// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "render/draw_state.h"
#include "render/line_style.h"
#include "render/mesh_layer.h"
#include "render/shader.h"

namespace foldless {

/// The edges between triangles, drawn by the triangles themselves: with many of them that is
/// several times faster than a line for each, above all where the processor draws.
class WireLayer {
 public:
  explicit WireLayer(const std::filesystem::path& shader_folder);

  /// The mesh as it is now.
  void upload(const MeshLayer& mesh);
  /// One sheet of it. Dashes and round ends are no matter of edges that meet.
  void draw(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
            const LineStyle& style) const;

 private:
  ShaderProgram program_;
  Buffer corners_;
  VertexArray triangles_;
};

}  // namespace foldless
