// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render_target.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/error.h"
#include "render/gl_objects.h"

namespace foldless {
namespace {

/// A framebuffer with one colour buffer of its own.
struct ColourBuffer {
  Framebuffer framebuffer;
  Renderbuffer colour;
};

void forget_errors() {
  while (glGetError() != GL_NO_ERROR) {
  }
}

GLint limit_of(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Nothing when the context refuses. `samples` 0: not multisampled.
std::optional<ColourBuffer> make_buffer(int width, int height, int samples) {
  ColourBuffer buffer;
  forget_errors();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.colour.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, buffer.framebuffer.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            buffer.colour.id());
  const bool is_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (glGetError() != GL_NO_ERROR || !is_complete) return std::nullopt;
  return buffer;
}

void straighten_alpha(Image& image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4) {
    const int alpha = image.pixels[p + 3];
    if (alpha == 255 || alpha == 0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[p + c] =
          static_cast<std::uint8_t>(std::min((image.pixels[p + c] * 255 + alpha / 2) / alpha, 255));
  }
}

/// GL counts rows from below.
void turn_over(Image& image) {
  const auto row = 4 * static_cast<std::ptrdiff_t>(image.width);
  for (std::ptrdiff_t y = 0; y < image.height / 2; ++y) {
    const auto top = image.pixels.begin() + y * row;
    std::swap_ranges(top, top + row, image.pixels.end() - (y + 1) * row);
  }
}

}  // namespace

struct RenderTarget::Buffers {
  int width = 0;
  int height = 0;
  int samples = 1;
  std::optional<ColourBuffer> drawn;  ///< multisampled; absent: `resolved` is drawn into
  ColourBuffer resolved;

  GLuint draw_id() const { return drawn ? drawn->framebuffer.id() : resolved.framebuffer.id(); }
};

RenderTarget::RenderTarget(int width, int height, int samples) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  const int limit = std::min(limit_of(GL_MAX_RENDERBUFFER_SIZE), limit_of(GL_MAX_VIEWPORT_DIMS));
  if (width < 1 || height < 1 || width > limit || height > limit)
    throw Error("a picture of " + size + " pixels cannot be drawn; choose 1 to " +
                std::to_string(limit) + " a side");
  auto resolved = make_buffer(width, height, 0);
  if (!resolved) throw Error("there is no memory for a picture of " + size + " pixels");
  buffers_ =
      std::make_unique<Buffers>(Buffers{width, height, 1, std::nullopt, *std::move(resolved)});
  for (int n = std::min(samples, limit_of(GL_MAX_SAMPLES)); n > 1 && !buffers_->drawn; n /= 2) {
    buffers_->drawn = make_buffer(width, height, n);
    if (buffers_->drawn) buffers_->samples = n;
  }
  forget_errors();
  bind();
}

RenderTarget::~RenderTarget() = default;
RenderTarget::RenderTarget(RenderTarget&&) noexcept = default;
RenderTarget& RenderTarget::operator=(RenderTarget&&) noexcept = default;

int RenderTarget::width() const { return buffers_->width; }
int RenderTarget::height() const { return buffers_->height; }
int RenderTarget::samples() const { return buffers_->samples; }

void RenderTarget::bind() {
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->draw_id());
  glViewport(0, 0, buffers_->width, buffers_->height);
}

Image RenderTarget::read() {
  Image image(width(), height());
  if (buffers_->drawn) {
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, buffers_->drawn->framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, buffers_->resolved.framebuffer.id());
    glBlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffers_->resolved.framebuffer.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  bind();
  turn_over(image);
  straighten_alpha(image);
  return image;
}

}  // namespace foldless
