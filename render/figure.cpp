// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure.h"

#include <cstddef>
#include <optional>

#include "render/figure_panes.h"
#include "render/legend.h"
#include "render/offscreen.h"
#include "render/render_target.h"
#include "render/scene_renderer.h"

namespace foldless {
namespace {

/// Puts an opaque colour behind a picture.
void lay_on(const GroundColour& colour, Image& picture) {
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    const int alpha = picture.pixels[i + 3];
    for (std::size_t c = 0; c < colour.size(); ++c)
      picture.pixels[i + c] = static_cast<std::uint8_t>(
          (picture.pixels[i + c] * alpha + colour[c] * (255 - alpha) + 127) / 255);
    picture.pixels[i + 3] = 255;
  }
}

}  // namespace

struct FigureRenderer::Parts {
  explicit Parts(bool has_own_context) {
    if (has_own_context) context.emplace(1, 1, 1);
    scene.emplace();
  }
  ~Parts() { enter(); }

  void enter() {
    if (context) context->make_current();
  }

  void fit_target(const FigureOptions& options);
  void fit_texture(const FigureOptions& options);

  std::optional<Offscreen> context;  ///< absent: whichever is current
  std::optional<SceneRenderer> scene;
  std::optional<RenderTarget> target;
  int samples_asked = 0;
  std::shared_ptr<const TexturePieces> texture;
  std::optional<Box> texture_place;
};

void FigureRenderer::Parts::fit_target(const FigureOptions& options) {
  const bool fits = target && target->width() == options.width &&
                    target->height() == options.height && samples_asked == options.samples;
  if (!fits) target.emplace(options.width, options.height, options.samples);
  samples_asked = options.samples;
  target->bind();
}

void FigureRenderer::Parts::fit_texture(const FigureOptions& options) {
  if (texture == options.texture && texture_place == options.texture_place) return;
  options.texture ? scene->set_texture(*options.texture, options.texture_place)
                  : scene->clear_texture();
  texture = options.texture;
  texture_place = options.texture_place;
}

FigureRenderer::FigureRenderer() : parts_(std::make_unique<Parts>(true)) {}
FigureRenderer::FigureRenderer(InCurrentContext) : parts_(std::make_unique<Parts>(false)) {}
FigureRenderer::~FigureRenderer() = default;

Image FigureRenderer::render(const Snapshot& snapshot, const FigureOptions& options) {
  parts_->enter();
  parts_->fit_target(options);
  parts_->fit_texture(options);
  parts_->scene->set_parts(options.parts);
  ViewOptions ground = options.style;
  if (options.ground) ground.background = Background::transparent;
  const Viewport whole{0, 0, options.width, options.height};
  parts_->scene->draw({}, {.viewport = whole}, ground);
  for (const FigurePane& pane : figure_panes(snapshot, options))
    parts_->scene->draw(snapshot,
                        {.viewport = pane.viewport,
                         .camera = pane.camera,
                         .energy_densities = options.energy_densities},
                        pane.style);
  Image image = parts_->target->read();
  const auto& range = parts_->scene->heat_range();
  if (range && options.has_legend) draw_legend(image, *range, options.style);
  if (options.ground) lay_on(*options.ground, image);
  return image;
}

Image render_figure(const Snapshot& snapshot, const FigureOptions& options) {
  return FigureRenderer().render(snapshot, options);
}

}  // namespace foldless
