// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "render/distortion.h"
#include "render/draw_state.h"
#include "render/fill_texture.h"
#include "render/mesh_layer.h"
#include "render/theme.h"

namespace foldless {

/// The insides of the triangles: a checkerboard or an image fixed to the rest mesh, or the colours
/// of a heat map. Triangles are not antialiased one by one, so that no seam shows between them.
class FillLayer {
 public:
  explicit FillLayer(const std::filesystem::path& shader_folder);

  /// An image instead of the checkerboard, or the checkerboard again. The image fills `place` of
  /// the rest plane; absent: the box of the rest mesh. Throws Error as FillTexture.
  void set_texture(const TextureLevels* image, const std::optional<Box>& place = std::nullopt);

  /// `squares` of the checkerboard lie along the longer side of the rest mesh's box.
  void draw(const Frame& frame, const MeshLayer& mesh, const CanvasColours& colours,
            double squares) const;
  /// The triangles that are clockwise on screen, in one colour: the folded ones.
  void draw_folded(const Frame& frame, const MeshLayer& mesh, const glm::vec4& colour) const;
  /// One colour of viridis a triangle.
  void draw_heat(const Frame& frame, const MeshLayer& mesh, const Distortion& distortion);

 private:
  void upload_heat(const MeshLayer& mesh, const Distortion& distortion);

  ShaderProgram fill_;
  ShaderProgram heat_;
  std::optional<FillTexture> image_;
  std::optional<Box> image_place_;
  Texture heat_colours_;
};

}  // namespace foldless
