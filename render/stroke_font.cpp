// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render/blend.h"

namespace foldless {
namespace {

constexpr double kCellHeight = 6;  // grid steps of a digit
constexpr double kAdvance = 1.9;   // grid steps between glyphs

/// Pairs of digits are points (x, y) of a grid with y up; a space lifts the pen.
struct Glyph {
  char letter;
  double width;
  std::string_view strokes;
};

constexpr std::array<Glyph, 18> kGlyphs{{
    {'0', 4, "103041453616050110"},
    {'1', 2, "052620"},
    {'2', 4, "051636454403000040"},
    {'3', 4, "05163645443342413010 01102333"},
    {'4', 4, "30360242"},
    {'5', 4, "4606033342413010 1001"},
    {'6', 4, "453616050110304142330302"},
    {'7', 4, "064610"},
    {'8', 4, "13040516364544331302011030414233"},
    {'9', 4, "0110304145361605041343"},
    {'.', 0, "0000"},
    {'-', 3, "0333"},
    {'+', 4, "0343 2125"},
    {'e', 4, "02424334140301103040"},
    {'s', 4, "44140301103041433414"},
    {'/', 3, "0036"},
    {'A', 4, "002640 1232"},
    {'\'', 0, "0604"},
}};

const Glyph* glyph_of(char letter) {
  const auto* found = std::find_if(kGlyphs.begin(), kGlyphs.end(),
                                   [&](const Glyph& g) { return g.letter == letter; });
  return found == kGlyphs.end() ? nullptr : found;
}

double width_of(char letter) {
  const Glyph* glyph = glyph_of(letter);
  return glyph ? glyph->width : 2;
}

/// StrokeLines of a glyph whose lower left grid point is at `corner`, in pixels with y down.
void add_segments(std::vector<StrokeLine>& segments, const Glyph& glyph, glm::dvec2 corner,
                  double step) {
  bool is_pen_down = false;
  glm::dvec2 pen{0, 0};
  for (std::size_t i = 0; i + 1 < glyph.strokes.size();) {
    if (glyph.strokes[i] == ' ') {
      is_pen_down = false;
      ++i;
      continue;
    }
    const glm::dvec2 point =
        corner + step * glm::dvec2(glyph.strokes[i] - '0', '0' - glyph.strokes[i + 1]);
    if (is_pen_down) segments.push_back({pen, point});
    pen = point;
    is_pen_down = true;
    i += 2;
  }
}

double distance_to(const StrokeLine& s, glm::dvec2 p) {
  const glm::dvec2 way = s.b - s.a;
  const double length_squared = glm::dot(way, way);
  const double t =
      length_squared > 0 ? std::clamp(glm::dot(p - s.a, way) / length_squared, 0.0, 1.0) : 0.0;
  return glm::distance(p, s.a + t * way);
}

double distance_to(const std::vector<StrokeLine>& segments, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const StrokeLine& segment : segments) nearest = std::min(nearest, distance_to(segment, p));
  return nearest;
}

}  // namespace

double stroke_text_width(std::string_view text, double height) {
  double width = 0;
  for (const char letter : text) width += width_of(letter) + kAdvance;
  return text.empty() ? 0 : (width - kAdvance) * height / kCellHeight;
}

double stroke_width(double height) { return 2 * std::max(0.5, 0.07 * height); }

std::vector<StrokeLine> stroke_lines(std::string_view text, const StrokeText& place) {
  const double step = place.height / kCellHeight;
  std::vector<StrokeLine> lines;
  glm::dvec2 corner = place.baseline;
  for (const char letter : text) {
    if (const Glyph* glyph = glyph_of(letter)) add_segments(lines, *glyph, corner, step);
    corner.x += step * (width_of(letter) + kAdvance);
  }
  return lines;
}

void draw_stroke_text(Image& image, std::string_view text, const StrokeText& place) {
  const std::vector<StrokeLine> lines = stroke_lines(text, place);
  const double half_width = 0.5 * stroke_width(place.height);
  const double width = stroke_text_width(text, place.height);
  const auto reach = static_cast<int>(std::ceil(half_width + 1));
  const auto left = static_cast<int>(place.baseline.x) - reach;
  const auto right = static_cast<int>(place.baseline.x + width) + reach;
  const auto bottom = static_cast<int>(place.baseline.y) + reach;
  const auto top = static_cast<int>(place.baseline.y - place.height) - reach;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double coverage = half_width + 0.5 - distance_to(lines, {x + 0.5, y + 0.5});
      glm::vec4 colour = place.colour;
      colour.a *= static_cast<float>(std::clamp(coverage, 0.0, 1.0));
      blend(image, x, y, colour);
    }
}

}  // namespace foldless
