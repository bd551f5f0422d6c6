// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/app_icon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace foldless {
namespace {

constexpr int kSamples = 4;  // across a pixel
constexpr glm::vec4 kNothing{0}, kPlate{0.11F, 0.13F, 0.17F, 1}, kLight{0.91F, 0.89F, 0.83F, 1},
    kBlue{0.42F, 0.55F, 0.71F, 1}, kMiddle{0.66F, 0.72F, 0.77F, 1}, kHandle{1, 0.62F, 0.2F, 1};

// In a unit square, y down.
constexpr glm::vec2 kTop{0.5F, 0.2F}, kLeft{0.16F, 0.8F}, kRight{0.84F, 0.8F}, kInside{0.5F, 0.6F};

struct Face {
  std::array<glm::vec2, 3> corners;
  glm::vec4 colour;
};
constexpr std::array<Face, 3> kFaces{{{{kTop, kLeft, kInside}, kLight},
                                      {{kTop, kInside, kRight}, kBlue},
                                      {{kInside, kLeft, kRight}, kMiddle}}};

bool is_inside(const Face& face, glm::vec2 p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec2 a = face.corners[i], along = face.corners[(i + 1) % 3] - a;
    if (along.x * (p.y - a.y) - along.y * (p.x - a.x) > 0) return false;
  }
  return true;
}

/// A square with round corners behind all.
bool is_on_plate(glm::vec2 p) {
  constexpr float kRadius = 0.2F;
  const glm::vec2 beyond = glm::max(glm::abs(p - 0.5F) - (0.5F - kRadius), glm::vec2(0));
  return glm::length(beyond) <= kRadius;
}

glm::vec4 colour_at(glm::vec2 p) {
  if (glm::distance(p, kTop) < 0.1F) return kHandle;
  const auto* face = std::ranges::find_if(kFaces, [p](const Face& f) { return is_inside(f, p); });
  if (face != kFaces.end()) return face->colour;
  return is_on_plate(p) ? kPlate : kNothing;
}

/// The mean of the samples in a pixel, straight alpha.
glm::vec4 pixel_at(int x, int y, int side) {
  glm::vec4 sum(0);
  for (int j = 0; j < kSamples; ++j)
    for (int i = 0; i < kSamples; ++i) {
      const glm::vec2 inside(static_cast<float>(kSamples * x + i) + 0.5F,
                             static_cast<float>(kSamples * y + j) + 0.5F);
      const glm::vec4 colour = colour_at(inside / static_cast<float>(kSamples * side));
      sum += glm::vec4(glm::vec3(colour) * colour.a, colour.a);
    }
  if (sum.a > 0) sum = glm::vec4(glm::vec3(sum) / sum.a, sum.a / (kSamples * kSamples));
  return sum;
}

}  // namespace

Image app_icon(int side) {
  Image icon(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::vec4 pixel = pixel_at(x, y, side);
      for (int c = 0; c < 4; ++c)
        icon.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(255 * pixel[c]));
    }
  return icon;
}

}  // namespace foldless
