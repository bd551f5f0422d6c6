// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/frames_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

constexpr double kPixels = 1024;  ///< along the longer side
constexpr double kMargin = 0.03;  ///< of the longer side

}  // namespace

FramesBox box_round(const std::vector<SolvedFrame>& frames) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  FramesBox box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const SolvedFrame& frame : frames)
    for (const int v : frame.snapshot->triangles->reshaped()) {
      const Vec2 p = frame.snapshot->deformed.col(v);
      box.min = box.min.cwiseMin(p);
      box.max = box.max.cwiseMax(p);
    }
  const double margin = kMargin * std::max(box.width(), box.height());
  box.min.array() -= margin;
  box.max.array() += margin;
  return box;
}

PictureSize size_for(const FramesBox& box) {
  const double scale = kPixels / std::max(box.width(), box.height());
  const auto pixels = [&](double length) {
    return 2 * std::max(1, static_cast<int>(std::lround(0.5 * scale * length)));
  };
  return {pixels(box.width()), pixels(box.height())};
}

double length_of_a_pixel(const FramesBox& box, const std::optional<PictureSize>& size) {
  const auto [width, height] = size.value_or(size_for(box));
  return std::max(box.width() / width, box.height() / height);
}

}  // namespace foldless
