// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen.h"

#include <array>
#include <cstdint>
#include <optional>

#include "core/error.h"
#include "render/osmesa.h"
#include "render/render_target.h"

namespace foldless {
namespace {

struct DestroyContext {
  void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};
using ContextPointer = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, DestroyContext>;

ContextPointer make_context() {
  constexpr std::array<int, 9> kAttributes{OSMESA_FORMAT,
                                           OSMESA_RGBA,
                                           OSMESA_PROFILE,
                                           OSMESA_CORE_PROFILE,
                                           OSMESA_CONTEXT_MAJOR_VERSION,
                                           3,
                                           OSMESA_CONTEXT_MINOR_VERSION,
                                           3,
                                           0};
  ContextPointer context(OSMesaCreateContextAttribs(kAttributes.data(), nullptr));
  if (!context)
    throw Error("OSMesa refuses an OpenGL 3.3 context; install libosmesa6 of Mesa 20 on");
  return context;
}

}  // namespace

struct Offscreen::Context {
  ContextPointer mesa;
  std::array<std::uint8_t, 4> window{};  ///< OSMesa wants a buffer of its own; we never draw there
  int wanted_samples = 1;
  std::optional<RenderTarget> target;
};

Offscreen::Offscreen(int width, int height, int samples) : context_(std::make_unique<Context>()) {
  context_->mesa = make_context();
  context_->wanted_samples = samples;
  make_current();
  resize(width, height);
}

Offscreen::~Offscreen() {
  OSMesaMakeCurrent(context_->mesa.get(), context_->window.data(), GL_UNSIGNED_BYTE, 1, 1);
  context_->target.reset();
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

void Offscreen::make_current() {
  if (!OSMesaMakeCurrent(context_->mesa.get(), context_->window.data(), GL_UNSIGNED_BYTE, 1, 1))
    throw Error("OSMesa cannot make its OpenGL context current");
  if (gladLoadGL(OSMesaGetProcAddress) == 0)
    throw Error("OSMesa offers no OpenGL 3.3; install libosmesa6 of Mesa 20 on");
}

void Offscreen::bind() { context_->target->bind(); }

void Offscreen::resize(int width, int height) {
  context_->target.reset();
  context_->target.emplace(width, height, context_->wanted_samples);
}

int Offscreen::width() const { return context_->target->width(); }
int Offscreen::height() const { return context_->target->height(); }
int Offscreen::samples() const { return context_->target->samples(); }

Image Offscreen::read() { return context_->target->read(); }

}  // namespace foldless
