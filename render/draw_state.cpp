// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/draw_state.h"

namespace foldless {

void use_in_frame(const ShaderProgram& program, const Frame& frame) {
  program.use();
  program.set("clip_scale", frame.clip.scale);
  program.set("clip_offset", frame.clip.offset);
  program.set("viewport", frame.viewport);
  program.set("ui_scale", frame.ui_scale);
}

DrawState::DrawState(const Viewport& viewport) {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
}

DrawState::~DrawState() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
}

NoBlending::NoBlending() { glDisable(GL_BLEND); }
NoBlending::~NoBlending() { glEnable(GL_BLEND); }

void clear_canvas(const glm::vec4& colour) {
  glClearColor(colour.r * colour.a, colour.g * colour.a, colour.b * colour.a, colour.a);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace foldless
