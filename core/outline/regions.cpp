// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/regions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/outline/distance_transform.h"
#include "core/outline/level_set.h"
#include "core/outline/loops.h"
#include "core/outline/simplify.h"
#include "core/outline/specks.h"

namespace foldless {
namespace {

constexpr double kMostCells = 2e6;
constexpr std::size_t kMostLoops = 1000;

void check_options(const AlphaMap& alpha, const RegionOptions& options) {
  if (alpha.width < 1 || alpha.height < 1) throw Error("the image has no pixels");
  if (!(options.threshold > 0 && options.threshold <= 1))
    throw Error("the threshold of alpha must be greater than 0 and at most 1");
  const double longest = std::max(alpha.width, alpha.height);
  if (!(options.margin >= 0 && options.margin <= longest))
    throw Error("the margin must be at least 0 pixels and no more than the image has");
  if (!(options.simplify >= 0 && options.simplify <= longest))
    throw Error("the simplification must be at least 0 pixels and no more than the image has");
}

/// Alpha above the threshold, in blocks of pixels where there are many: positive in the figure.
ScalarGrid excess_of(const AlphaMap& alpha, double threshold) {
  const double pixels = static_cast<double>(alpha.width) * alpha.height;
  const double shrink = std::min(1.0, std::sqrt(kMostCells / pixels));
  const auto cells = [&](int length) { return std::max(1, static_cast<int>(shrink * length)); };
  const auto level = static_cast<float>(std::ceil(255 * threshold) - 0.5);
  ScalarGrid excess(cells(alpha.width), cells(alpha.height), -level);
  for (int y = 0; y < alpha.height; ++y) {
    const auto row = static_cast<int>(static_cast<long>(y) * excess.height / alpha.height);
    for (int x = 0; x < alpha.width; ++x) {
      float& cell =
          excess.at(static_cast<int>(static_cast<long>(x) * excess.width / alpha.width), row);
      cell = std::max(cell, static_cast<float>(alpha.at(x, y)) - level);
    }
  }
  return excess;
}

/// Positive as far as `margin` cells round the figure.
ScalarGrid widened(const ScalarGrid& figure, double margin) {
  ScalarGrid field = distance_transform(figure);
  for (float& value : field.values) value = static_cast<float>(margin + 0.5) - value;
  return field;
}

void scale(std::vector<Loop>& loops, const Vec2& factor) {
  for (Loop& loop : loops)
    for (Vec2& corner : loop) corner = corner.cwiseProduct(factor);
}

/// Fills small holes, and leaves out what is inside of them; returns how many.
int fill_small_holes(std::vector<Loop>& loops, double area) {
  const auto is_small = [area](const Loop& loop) {
    const double signed_area = area_of(loop);
    return signed_area < 0 && signed_area > -area;
  };
  return static_cast<int>(std::erase_if(loops, is_small));
}

/// The boundary that a hole lies in: the smallest of those round it.
std::size_t boundary_round(const Loop& hole, const std::vector<Outline>& outlines) {
  std::size_t smallest = outlines.size();
  double smallest_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const double area = area_of(outlines[i].boundary);
    if (area >= smallest_area || !encloses(outlines[i].boundary, hole.front())) continue;
    smallest = i;
    smallest_area = area;
  }
  return smallest;
}

void check_count(const std::vector<Loop>& loops) {
  if (loops.size() > kMostLoops)
    throw Error("the image has " + std::to_string(loops.size()) + " parts and holes, more than " +
                std::to_string(kMostLoops) + "; raise the threshold or the margin");
}

std::vector<Outline> nested(std::vector<Loop> loops) {
  std::vector<Outline> outlines;
  for (Loop& loop : loops)
    if (area_of(loop) > 0) outlines.push_back({std::move(loop), {}});
  for (Loop& loop : loops)
    if (!loop.empty()) {
      const std::size_t i = boundary_round(loop, outlines);
      if (i < outlines.size()) outlines[i].holes.push_back(std::move(loop));
    }
  return outlines;
}

}  // namespace

Regions regions_of(const AlphaMap& alpha, const RegionOptions& options,
                   const std::stop_token& stop) {
  check_options(alpha, options);
  ScalarGrid figure = excess_of(alpha, options.threshold);
  const Vec2 cell(static_cast<double>(alpha.width) / figure.width,
                  static_cast<double>(alpha.height) / figure.height);
  Regions regions;
  const double pixels_per_cell = std::sqrt(cell.prod());
  regions.specks = remove_specks(figure, options.speck_area / cell.prod());
  if (std::ranges::none_of(figure.values, [](float value) { return value > 0; }))
    throw Error("the image is transparent everywhere; choose another, or lower the threshold");
  if (stop.stop_requested()) return {};
  if (options.margin > 0) figure = widened(figure, options.margin / pixels_per_cell);
  std::vector<Loop> loops = level_set(figure);
  scale(loops, cell);
  regions.filled_holes = fill_small_holes(loops, options.speck_area);
  check_count(loops);
  if (stop.stop_requested()) return {};
  regions.outlines = nested(simplified(loops, options.simplify));
  return regions;
}

}  // namespace foldless
