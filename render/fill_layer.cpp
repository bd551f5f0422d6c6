// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/fill_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "render/colormap.h"

namespace foldless {
namespace {

constexpr std::size_t kTexelsOfARow = 1024;  // every GL 3.3 takes a texture that wide
constexpr std::size_t kShades = 1024;

using Colour = std::array<std::uint8_t, 4>;

std::vector<Colour> shades() {
  std::vector<Colour> table(kShades);
  for (std::size_t i = 0; i < kShades; ++i) {
    const glm::vec3 rgb = viridis(static_cast<float>(i) / (kShades - 1)) * 255.0F + 0.5F;
    table[i] = {static_cast<std::uint8_t>(rgb.r), static_cast<std::uint8_t>(rgb.g),
                static_cast<std::uint8_t>(rgb.b), 255};
  }
  return table;
}

/// Premultiplied; one decade of stiffness from 1 is a third of the way to the densest.
Colour tint(float factor) {
  constexpr std::array<float, 3> kStiff{230, 159, 0}, kSlack{0, 114, 178};
  constexpr float kFaintest = 0.3F, kDensest = 0.75F, kDecades = 3;
  const float decades = std::log10(factor);
  if (decades == 0) return {};
  const float density =
      std::min(kFaintest + (kDensest - kFaintest) * std::abs(decades) / kDecades, kDensest);
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] =
        static_cast<std::uint8_t>(std::lround((decades > 0 ? kStiff : kSlack)[c] * density));
  colour[3] = static_cast<std::uint8_t>(std::lround(255 * density));
  return colour;
}

/// One texel for each of so many triangles, row by row.
template <typename ColourOf>
void upload_colours(const Texture& texture, std::size_t triangles, const ColourOf& colour_of) {
  const std::size_t rows = triangles / kTexelsOfARow + 1;
  std::vector<Colour> texels(rows * kTexelsOfARow);
  for (std::size_t k = 0; k < triangles; ++k) texels[k] = colour_of(k);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kTexelsOfARow, static_cast<GLsizei>(rows), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, texels.data());
}

/// What fill.vert counts periods of, in the mesh's local frame.
void set_pattern(const ShaderProgram& program, const glm::vec2& origin, const glm::dvec2& period) {
  program.set("pattern_origin", origin);
  program.set("pattern_size", glm::vec2(period));
}

}  // namespace

FillLayer::FillLayer(const std::filesystem::path& shader_folder)
    : board_({"board", "fill"}, shader_folder),
      image_({"image", "fill"}, shader_folder),
      heat_({"heat"}, shader_folder) {}

void FillLayer::set_texture(const TexturePieces& pieces, const std::optional<Box>& place) {
  using Beyond = FillTexture::Beyond;
  std::vector<Piece> made;  // before the old ones go
  for (const TexturePiece& piece : pieces) {
    made.push_back({std::nullopt, piece.within});
    // A layer ends where it was cut down; the mesh has a margin.
    const Beyond beyond = piece.within == Box{} ? Beyond::edge : Beyond::nothing;
    if (piece.levels) made.back().image.emplace(piece.levels, beyond);
  }
  pieces_ = std::move(made);
  image_place_ = place;
}

std::size_t FillLayer::upload_texture(std::size_t pixels) {
  std::size_t done = 0;
  for (Piece& piece : pieces_)
    if (piece.image && done < pixels) done += piece.image->upload(pixels - done);
  return done;
}

bool FillLayer::has_whole_texture() const {
  return std::ranges::all_of(
      pieces_, [](const Piece& piece) { return !piece.image || piece.image->is_whole(); });
}

void FillLayer::draw(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                     const Checkerboard& board) const {
  if (pieces_.empty()) return draw_board(frame, mesh, sheet, board);
  use_in_frame(image_, frame);
  image_.set("image", 0);
  for (std::size_t part = 0; part < mesh.part_count(); ++part) {
    const Piece& piece = pieces_[std::min(part, pieces_.size() - 1)];
    if (!piece.image || !mesh.has_triangles(sheet, part)) continue;
    use_image(piece, mesh);
    mesh.draw_triangles(sheet, part);
  }
}

void FillLayer::draw_board(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                           const Checkerboard& board) const {
  use_in_frame(board_, frame);
  const glm::dvec2 extent = (mesh.rest_box().max - mesh.rest_box().min) / mesh.local().unit;
  const double period = 2 * std::max(extent.x, extent.y) / board.squares;
  set_pattern(board_, mesh.local().to_local(mesh.rest_box().min), glm::dvec2(period));
  board_.set("middle", 0.5F * (board.light + board.dark));
  board_.set("half_difference", 0.5F * (board.light - board.dark));
  const NoBlending opaque;
  mesh.draw_triangles(sheet);
}

void FillLayer::use_image(const Piece& piece, const MeshLayer& mesh) const {
  const Box& whole = image_place_ ? *image_place_ : mesh.rest_box();
  const glm::dvec2 extent = whole.max - whole.min;
  set_pattern(image_, mesh.local().to_local(whole.min + piece.within.min * extent),
              (piece.within.max - piece.within.min) * extent / mesh.local().unit);
  piece.image->bind();
}

void FillLayer::draw_folded(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                            const glm::vec4& colour) const {
  use_in_frame(board_, frame);
  set_pattern(board_, glm::vec2(0), glm::dvec2(1));
  board_.set("middle", colour);
  board_.set("half_difference", glm::vec4(0));
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  mesh.draw_triangles(sheet);
  glDisable(GL_CULL_FACE);
}

void FillLayer::upload_heat(const MeshLayer& mesh, const Distortion& distortion) {
  const std::vector<Colour> table = shades();
  const std::vector<int>& order = mesh.order();
  upload_colours(heat_colours_, order.size(), [&](std::size_t k) {
    const double value = distortion.values[static_cast<std::size_t>(order[k])];
    const double place = position_on(distortion.range, value);
    return table[static_cast<std::size_t>(std::lround(place * (kShades - 1)))];
  });
}

void FillLayer::upload_stiffness(const MeshLayer& mesh, std::span<const float> factors) {
  const std::vector<int>& order = mesh.order();
  upload_colours(stiffness_colours_, order.size(),
                 [&](std::size_t k) { return tint(factors[static_cast<std::size_t>(order[k])]); });
}

void FillLayer::draw_heat(const Frame& frame, const MeshLayer& mesh, std::size_t sheet) const {
  const NoBlending opaque;
  draw_colours(frame, mesh, sheet, heat_colours_);
}

void FillLayer::draw_stiffness(const Frame& frame, const MeshLayer& mesh, std::size_t sheet) const {
  draw_colours(frame, mesh, sheet, stiffness_colours_);
}

void FillLayer::draw_colours(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                             const Texture& colours) const {
  use_in_frame(heat_, frame);
  heat_.set("colours", 0);
  heat_.set("first_triangle", static_cast<int>(mesh.first_triangle(sheet)));
  glBindTexture(GL_TEXTURE_2D, colours.id());
  mesh.draw_triangles(sheet);
}

}  // namespace foldless
