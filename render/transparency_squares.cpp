// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/transparency_squares.h"

#include <algorithm>
#include <cmath>

#include "render/draw_state.h"

namespace foldless {
namespace {

constexpr double kSide = 8;  // design pixels

struct Greys {
  glm::vec4 light, dark;
};

Greys greys_of(Theme theme) {
  if (theme == Theme::light) return {glm::vec4(0.97F, 0.97F, 0.97F, 1), {0.86F, 0.86F, 0.86F, 1}};
  return {glm::vec4(0.36F, 0.36F, 0.37F, 1), {0.28F, 0.28F, 0.29F, 1}};
}

/// From the lower left of the framebuffer.
glm::dvec2 framebuffer_point(const TransparencySquares::Place& place, glm::dvec2 world) {
  const glm::dvec2 size(place.viewport.width, place.viewport.height);
  const glm::dvec2 pixel = world_to_pixel(place.camera, size, world);
  return {place.viewport.x + pixel.x, place.viewport.y + size.y - pixel.y};
}

/// Pixels of [low, high] that lie in [begin, begin + length).
struct Span {
  int begin, length;
  Span(double low, double high, int first, int count)
      : begin(static_cast<int>(std::clamp<double>(std::round(low), first, first + count))),
        length(static_cast<int>(std::clamp<double>(std::round(high), first, first + count)) -
               begin) {}
};

}  // namespace

TransparencySquares::TransparencySquares(const std::filesystem::path& shader_folder)
    : program_({"squares"}, shader_folder) {}

void TransparencySquares::draw(const Box& box, const Place& place, Theme theme) const {
  const DrawState state(place.viewport);
  const glm::dvec2 low = framebuffer_point(place, box.min),
                   high = framebuffer_point(place, box.max);
  const Span across(low.x, high.x, place.viewport.x, place.viewport.width);
  const Span up(low.y, high.y, place.viewport.y, place.viewport.height);
  glScissor(across.begin, up.begin, across.length, up.length);
  const double side = kSide * place.ui_scale;
  const auto [light, dark] = greys_of(theme);
  program_.use();
  // Near the origin, where floats are exact.
  program_.set("corner", glm::vec2(std::fmod(low.x, 2 * side), std::fmod(low.y, 2 * side)));
  program_.set("side", static_cast<float>(side));
  program_.set("light", light);
  program_.set("dark", dark);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace foldless
