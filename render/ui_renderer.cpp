// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ui_renderer.h"

#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "render/draw_state.h"
#include "render/gl_objects.h"
#include "render/shader.h"

namespace foldless {

struct UiRenderer::Resources {
  ShaderProgram program{{"ui"}};
  ShaderProgram fill{{"ui_fill", "ui"}};
  VertexArray vertex_array;
  Buffer vertices;
  Buffer indices;
  Texture font;
  ImVec2 white{};  ///< where the atlas is white
};

namespace {

void describe_vertices() {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                        offset(offsetof(ImDrawVert, pos)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert),
                        offset(offsetof(ImDrawVert, uv)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert),
                        offset(offsetof(ImDrawVert, col)));
}

void set_state() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  // Destination alpha stays what it was or grows: a screenshot of the window is opaque.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// A clip rectangle in framebuffer pixels, y down.
struct Clip {
  glm::vec2 min, max;
  bool is_empty() const { return max.x <= min.x || max.y <= min.y; }
};

Clip clip_of(const ImDrawCmd& command, const ImDrawData& data, const glm::vec2& framebuffer) {
  const glm::vec2 origin{data.DisplayPos.x, data.DisplayPos.y};
  const glm::vec2 scale{data.FramebufferScale.x, data.FramebufferScale.y};
  const glm::vec2 low{command.ClipRect.x, command.ClipRect.y};
  const glm::vec2 high{command.ClipRect.z, command.ClipRect.w};
  return {glm::max((low - origin) * scale, glm::vec2(0)),
          glm::min((high - origin) * scale, framebuffer)};
}

void set_display(const ShaderProgram& program, const ImDrawData& data) {
  program.use();
  program.set("display_origin", glm::vec2(data.DisplayPos.x, data.DisplayPos.y));
  program.set("display_size", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
}

/// What a triangle needs, the dearest first.
enum class Paint {
  atlas,   ///< a picture or a letter
  plain,   ///< colour alone
  opaque,  ///< colour alone that hides what is below
};

/// Triangles of a command that follow each other, as indices of it.
struct TriangleRun {
  unsigned int first;
  unsigned int count;
  Paint paint;
};

/// The triangles of a command.
struct CommandTriangles {
  const ImDrawCmd& command;
  const ImDrawList& list;
  ImVec2 white;  ///< where the atlas is

  const ImDrawVert& corner(unsigned int i) const {
    const auto index =
        static_cast<unsigned int>(list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
    return list.VtxBuffer[static_cast<int>(index + command.VtxOffset)];
  }
  /// Of the one that begins at index `i`.
  Paint paint(unsigned int i) const {
    bool is_opaque = true;
    for (unsigned int k = i; k < i + 3; ++k) {
      const ImDrawVert& v = corner(k);
      if (v.uv.x != white.x || v.uv.y != white.y) return Paint::atlas;
      is_opaque = is_opaque && v.col >> IM_COL32_A_SHIFT == 255;
    }
    return is_opaque ? Paint::opaque : Paint::plain;
  }
  float doubled_area(unsigned int i) const {
    const ImVec2 &a = corner(i).pos, &b = corner(i + 1).pos, &c = corner(i + 2).pos;
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
};

/// A command in runs: those without a picture that cover much (backgrounds, curves, bars) apart.
std::vector<TriangleRun> runs_of(const CommandTriangles& triangles) {
  constexpr float kMuch = 3000;  // [square pixels] what another program costs is less
  std::vector<TriangleRun> runs;
  const auto add = [&runs](const TriangleRun& run) {
    if (runs.empty() || runs.back().paint != run.paint)
      runs.push_back(run);
    else
      runs.back().count += run.count;
  };
  const unsigned int end = triangles.command.ElemCount;
  for (unsigned int i = 0; i < end;) {
    const unsigned int first = i;
    const Paint paint = triangles.paint(i);
    float doubled_area = 0;
    for (; i < end && triangles.paint(i) == paint; i += 3)
      doubled_area += triangles.doubled_area(i);
    add({first, i - first, doubled_area > 2 * kMuch ? paint : Paint::atlas});
  }
  return runs;
}

void draw_run(const ImDrawCmd& command, const TriangleRun& run) {
  const auto first =
      reinterpret_cast<const void*>((command.IdxOffset + run.first) * sizeof(ImDrawIdx));
  glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(run.count),
                           sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, first,
                           static_cast<GLint>(command.VtxOffset));
}

}  // namespace

void UiRenderer::draw_list(const ImDrawList& list, const ImDrawData& data,
                           const glm::vec2& framebuffer) {
  glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
               GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
               GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback && command.UserCallback != ImDrawCallback_ResetRenderState) {
      command.UserCallback(&list, &command);
      continue;
    }
    const Clip clip = clip_of(command, data, framebuffer);
    if (clip.is_empty() || command.ElemCount == 0) continue;
    glScissor(static_cast<GLint>(clip.min.x), static_cast<GLint>(framebuffer.y - clip.max.y),
              static_cast<GLsizei>(clip.max.x - clip.min.x),
              static_cast<GLsizei>(clip.max.y - clip.min.y));
    const auto texture = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.TextureId));
    glBindTexture(GL_TEXTURE_2D, texture);
    for (const TriangleRun& run : runs_of({command, list, resources_->white})) {
      (run.paint == Paint::atlas ? resources_->program : resources_->fill).use();
      if (run.paint != Paint::opaque) {
        draw_run(command, run);
      } else {
        const NoBlending opaque;
        draw_run(command, run);
      }
    }
  }
}

UiRenderer::UiRenderer() : resources_(std::make_unique<Resources>()) {
  glBindVertexArray(resources_->vertex_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, resources_->vertices.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, resources_->indices.id());
  describe_vertices();
  glBindVertexArray(0);
}

UiRenderer::~UiRenderer() = default;

void UiRenderer::upload_fonts(ImFontAtlas& atlas) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  glBindTexture(GL_TEXTURE_2D, resources_->font.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(resources_->font.id())));
  atlas.ClearTexData();
  resources_->white = atlas.TexUvWhitePixel;
}

void UiRenderer::draw(const ImDrawData& data) {
  const glm::vec2 framebuffer{data.DisplaySize.x * data.FramebufferScale.x,
                              data.DisplaySize.y * data.FramebufferScale.y};
  if (framebuffer.x < 1 || framebuffer.y < 1) return;
  glViewport(0, 0, static_cast<GLsizei>(framebuffer.x), static_cast<GLsizei>(framebuffer.y));
  set_state();
  set_display(resources_->fill, data);
  set_display(resources_->program, data);
  resources_->program.set("atlas", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
  glBindVertexArray(resources_->vertex_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, resources_->vertices.id());
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data, framebuffer);
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace foldless
