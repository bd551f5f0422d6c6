// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/marker_layer.h"

#include <cstddef>

namespace foldless {

MarkerLayer::MarkerLayer(const std::filesystem::path& shader_folder)
    : program_({"marker"}, shader_folder) {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  glBindVertexArray(markers_.id());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  for (GLuint attribute = 0; attribute < 4; ++attribute) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
  constexpr GLsizei kStride = sizeof(Marker);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Marker, centre)));
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Marker, radius)));
  glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Marker, fill)));
  glVertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Marker, rim)));
  glBindVertexArray(lines_.id());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void MarkerLayer::draw(const Frame& frame, const std::vector<Marker>& markers) const {
  if (markers.empty()) return;
  use_in_frame(program_, frame);
  glBindVertexArray(markers_.id());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(markers.size() * sizeof(Marker)),
               markers.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(markers.size()));
}

void MarkerLayer::draw_segments(const std::vector<glm::vec2>& ends) const {
  glBindVertexArray(lines_.id());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ends.size() * sizeof(glm::vec2)),
               ends.data(), GL_STREAM_DRAW);
  glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(ends.size()));
}

void MarkerLayer::draw_split_vertices(const Frame& frame, const MarkerScene& scene,
                                      const std::vector<int>& vertices) const {
  draw(frame, split_markers(scene, vertices));
}

void MarkerLayer::draw_handles(const Frame& frame, const MarkerScene& scene,
                               const LineLayer& lines) const {
  const HandleMarkers markers = handle_markers(scene);
  lines.begin(frame, markers.line_style);
  draw_segments(markers.line_ends);
  draw(frame, markers.targets);
  draw(frame, markers.handles);
}

}  // namespace foldless
