// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "render/distortion.h"
#include "render/draw_state.h"
#include "render/fill_texture.h"
#include "render/mesh_layer.h"
#include "render/theme.h"

namespace foldless {

/// What a mesh without an image is filled with.
struct Checkerboard {
  glm::vec4 light, dark;
  double squares = 20;  ///< along the longer side of the rest mesh's box
};

/// The insides of the triangles: a checkerboard or an image fixed to the rest mesh, or the colours
/// of a heat map. Triangles are not antialiased one by one, so that no seam shows between them.
class FillLayer {
 public:
  explicit FillLayer(const std::filesystem::path& shader_folder);

  /// An image instead of the checkerboard, or the checkerboard again. The image fills `place` of
  /// the rest plane; absent: the box of the rest mesh. Throws Error as FillTexture.
  void set_texture(const TextureLevels* image, const std::optional<Box>& place = std::nullopt);

  // Each draws one sheet of the mesh.

  /// The image, or else the checkerboard.
  void draw(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
            const Checkerboard& board) const;
  /// The triangles that are clockwise on screen, in one colour: the folded ones.
  void draw_folded(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                   const glm::vec4& colour) const;
  /// One colour of viridis a triangle, as uploaded.
  void draw_heat(const Frame& frame, const MeshLayer& mesh, std::size_t sheet) const;

  /// How stiff the triangles are, as uploaded, over what is drawn.
  void draw_stiffness(const Frame& frame, const MeshLayer& mesh, std::size_t sheet) const;

  // For all sheets of the mesh as it is now.

  /// The colours of a heat map.
  void upload_heat(const MeshLayer& mesh, const Distortion& distortion);
  /// Orange above 1, blue below, the denser the farther from it. One factor a triangle.
  void upload_stiffness(const MeshLayer& mesh, std::span<const float> factors);

 private:
  void draw_colours(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                    const Texture& colours) const;

  ShaderProgram fill_;
  ShaderProgram heat_;
  std::optional<FillTexture> image_;
  std::optional<Box> image_place_;
  Texture heat_colours_;
  Texture stiffness_colours_;
};

}  // namespace foldless
