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

constexpr std::size_t kHeatWidth = 1024;  // texels a row; every GL 3.3 takes a texture that wide
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

}  // namespace

FillLayer::FillLayer(const std::filesystem::path& shader_folder)
    : fill_("fill", shader_folder), heat_("heat", shader_folder) {
  glBindTexture(GL_TEXTURE_2D, heat_colours_.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void FillLayer::set_texture(const TextureLevels* image, const std::optional<Box>& place) {
  image_place_ = place;
  if (image) {
    image_ = FillTexture(*image);  // made before the old one goes
  } else {
    image_.reset();
  }
}

void FillLayer::draw(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                     const Checkerboard& board) const {
  const Box& box = image_ && image_place_ ? *image_place_ : mesh.rest_box();
  const glm::dvec2 extent = (box.max - box.min) / mesh.local().unit;
  use_in_frame(fill_, frame);
  fill_.set("box_min", mesh.local().to_local(box.min));
  fill_.set("box_size", glm::vec2(extent));
  fill_.set("square_size", static_cast<float>(std::max(extent.x, extent.y) / board.squares));
  fill_.set("light", board.light);
  fill_.set("dark", board.dark);
  fill_.set("is_textured", image_ ? 1 : 0);
  fill_.set("image", 0);
  if (image_) image_->bind();
  mesh.draw_triangles(sheet);
}

void FillLayer::draw_folded(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                            const glm::vec4& colour) const {
  use_in_frame(fill_, frame);
  fill_.set("box_size", glm::vec2(1));
  fill_.set("square_size", 1.0F);
  fill_.set("light", colour);
  fill_.set("dark", colour);
  fill_.set("is_textured", 0);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  mesh.draw_triangles(sheet);
  glDisable(GL_CULL_FACE);
}

void FillLayer::upload_heat(const MeshLayer& mesh, const Distortion& distortion) {
  const std::vector<Colour> table = shades();
  const std::size_t rows = distortion.values.size() / kHeatWidth + 1;
  std::vector<Colour> texels(rows * kHeatWidth);
  const std::vector<int>& order = mesh.order();
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double value = distortion.values[static_cast<std::size_t>(order[k])];
    const double place = position_on(distortion.range, value);
    texels[k] = table[static_cast<std::size_t>(std::lround(place * (kShades - 1)))];
  }
  glBindTexture(GL_TEXTURE_2D, heat_colours_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kHeatWidth, static_cast<GLsizei>(rows), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, texels.data());
}

void FillLayer::draw_heat(const Frame& frame, const MeshLayer& mesh, std::size_t sheet) const {
  use_in_frame(heat_, frame);
  heat_.set("colours", 0);
  heat_.set("first_triangle", static_cast<int>(mesh.first_triangle(sheet)));
  glBindTexture(GL_TEXTURE_2D, heat_colours_.id());
  mesh.draw_triangles(sheet);
}

}  // namespace foldless
