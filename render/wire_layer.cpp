// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/wire_layer.h"

#include <cstddef>

#include "render/wire_corners.h"

namespace foldless {

WireLayer::WireLayer(const std::filesystem::path& shader_folder)
    : program_({"wire"}, shader_folder) {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei kStride = sizeof(WireCorner);
  glBindVertexArray(triangles_.id());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(WireCorner, position)));
  glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(WireCorner, height)));
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(WireCorner, lengths)));
  glBindVertexArray(0);
}

void WireLayer::upload(const MeshLayer& mesh) {
  const std::vector<WireCorner> corners =
      wire_corners(mesh.corners(), mesh.order(), mesh.is_boundary(), mesh.local_positions());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(WireCorner)),
               corners.data(), GL_STREAM_DRAW);
}

void WireLayer::draw(const Frame& frame, const MeshLayer& mesh, std::size_t sheet,
                     const LineStyle& style) const {
  const std::size_t first = mesh.first_triangle(sheet);
  const std::size_t count = mesh.triangle_count(sheet);
  if (count == 0) return;
  use_in_frame(program_, frame);
  program_.set("half_width", 0.5F * style.width * frame.ui_scale);
  program_.set("fade_length", style.fade_below * frame.ui_scale);
  program_.set("colour", style.colour);
  glBindVertexArray(triangles_.id());
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first), static_cast<GLsizei>(3 * count));
}

}  // namespace foldless
