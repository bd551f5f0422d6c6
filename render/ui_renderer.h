// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <memory>

struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace foldless {

/// Draws the interface's triangles (ImDrawData) with our own GL 3.3 calls, so that the same frame
/// comes out of a window and of an off-screen buffer. Every function needs the context that the
/// object was made in to be current. Throws Error when the shaders cannot be built.
class UiRenderer {
 public:
  UiRenderer();
  ~UiRenderer();
  UiRenderer(const UiRenderer&) = delete;
  UiRenderer& operator=(const UiRenderer&) = delete;

  /// Rasterises the atlas and uploads it; call again whenever its fonts changed.
  void upload_fonts(ImFontAtlas& atlas);
  /// Draws over the framebuffer that is bound, in framebuffer pixels with the origin at its top
  /// left. Leaves blending and scissor off and the viewport at the whole framebuffer.
  void draw(const ImDrawData& data);

 private:
  void draw_list(const ImDrawList& list, const ImDrawData& data, const glm::vec2& framebuffer);

  struct Resources;
  std::unique_ptr<Resources> resources_;
};

}  // namespace foldless
