// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "render/distortion.h"
#include "render/draw_state.h"
#include "render/fill_texture.h"
#include "render/mesh_layer.h"
#include "render/texture_pieces.h"
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

  /// Images instead of the checkerboard, or with none the checkerboard again: one for the mesh, or
  /// one for each of its parts. What they are pieces of fills `place` of the rest plane; absent:
  /// the box of the rest mesh. They are brought by upload_texture(). Throws Error as FillTexture.
  void set_texture(const TexturePieces& pieces, const std::optional<Box>& place = std::nullopt);

  /// As FillTexture::upload(), of all images together.
  std::size_t upload_texture(std::size_t pixels);
  bool has_whole_texture() const;

  // Each draws one sheet of the mesh.

  /// The images, or else the checkerboard.
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
  /// An image on the graphics card, or nothing.
  struct Piece {
    std::optional<FillTexture> image;
    Box within;
  };

  void use_image(const Piece& piece, const MeshLayer& mesh) const;
  void draw_board(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                  const Checkerboard& board) const;
  void draw_colours(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                    const Texture& colours) const;

  ShaderProgram board_;
  ShaderProgram image_;
  ShaderProgram heat_;
  std::vector<Piece> pieces_;
  std::optional<Box> image_place_;
  Texture heat_colours_;
  Texture stiffness_colours_;
};

}  // namespace foldless
