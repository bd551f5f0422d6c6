// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_fill.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/export/triangle_map.h"
#include "render/colormap.h"

namespace foldless {
namespace {

constexpr int kShades = 1024;  // of the heat map, as on the graphics card

std::array<glm::dvec2, 3> corners_of(const PlacedMesh& mesh, const std::vector<glm::dvec2>& points,
                                     int triangle) {
  const auto [a, b, c] = mesh.vertices_of(triangle);
  return {points[a], points[b], points[c]};
}

Polygon corners_in_pane(const PlacedMesh& mesh, int triangle) {
  const auto corners = corners_of(mesh, mesh.places, triangle);
  return {corners.begin(), corners.end()};
}

bool is_finite(const AffineMap& map) {
  double sum = map.offset.x + map.offset.y;
  for (int column = 0; column < 2; ++column) sum += map.linear[column].x + map.linear[column].y;
  return std::isfinite(sum);
}

/// The map of a triangle's place in the rest plane to that in the pane.
AffineMap rest_to_pane(const PlacedMesh& mesh, int triangle) {
  return triangle_map(corners_of(mesh, mesh.rest, triangle),
                      corners_of(mesh, mesh.places, triangle));
}

/// Of the pane to the rest plane in units of squares, from the corner of the board, and back.
struct BoardMaps {
  AffineMap to_squares, to_pane;
};

/// Adds what of a polygon of the pane lies in dark squares of the board, which is so large: of
/// triangles that are all but flat the strips reach far over the rest plane.
void add_dark_parts(const VectorPane& pane, const Polygon& polygon, const BoardMaps& maps,
                    const Box& board) {
  Polygon on_board = polygon;
  for (glm::dvec2& p : on_board) p = maps.to_squares(p);
  on_board = clipped(std::move(on_board), board);
  if (on_board.empty()) return;
  glm::dvec2 low = on_board.front(), high = low;
  for (const glm::dvec2& p : on_board) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  for (double y = std::floor(low.y); y < high.y; ++y)
    for (double x = std::floor(low.x); x < high.x; ++x) {
      if (std::fmod(std::abs(x + y), 2.0) == 0) continue;
      Polygon part = clipped(on_board, {{x, y}, {x + 1, y + 1}});
      for (glm::dvec2& p : part) p = maps.to_pane(p);
      add_polygon(pane, std::move(part));
    }
}

bool is_opaque(const Image& image) {
  for (std::size_t p = 3; p < image.pixels.size(); p += 4)
    if (image.pixels[p] != 255) return false;
  return true;
}

/// What lies beyond an image.
enum class ImageBorder { repeated, clear };

/// The pixels of an image, with its outermost ones repeated over a border where that is not clear.
void copy_pixels(const Image& image, int border, ImageBorder kind, cairo_surface_t* surface) {
  const int stride = cairo_image_surface_get_stride(surface);
  unsigned char* rows = cairo_image_surface_get_data(surface);
  const int first = kind == ImageBorder::clear ? border : 0;
  for (int y = first; y < image.height + 2 * border - first; ++y)
    for (int x = first; x < image.width + 2 * border - first; ++x) {
      const std::uint8_t* from = image.at(std::clamp(x - border, 0, image.width - 1),
                                          std::clamp(y - border, 0, image.height - 1));
      const std::uint32_t pixel = std::uint32_t{from[3]} << 24 | std::uint32_t{from[0]} << 16 |
                                  std::uint32_t{from[1]} << 8 | from[2];
      unsigned char* to = rows + static_cast<std::ptrdiff_t>(y) * stride;
      reinterpret_cast<std::uint32_t*>(to)[x] = pixel;
    }
}

/// Pixels of the image, y down, to the rest plane, y up.
AffineMap image_to_rest(const VectorImage& image) {
  const glm::dvec2 inside(cairo_image_surface_get_width(image.surface.get()) - 2 * image.border,
                          cairo_image_surface_get_height(image.surface.get()) - 2 * image.border);
  const glm::dvec2 pixel = (image.place.max - image.place.min) / inside;
  return {glm::dmat2(pixel.x, 0, 0, -pixel.y),
          {image.place.min.x - image.border * pixel.x, image.place.max.y + image.border * pixel.y}};
}

VectorImage with_border(const Image& image, const Box& place, int border, ImageBorder kind) {
  VectorImage result;
  result.border = border;
  result.place = place;
  const bool has_clear_pixels = kind == ImageBorder::clear || !is_opaque(image);
  const cairo_format_t format = has_clear_pixels ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24;
  result.surface.reset(
      cairo_image_surface_create(format, image.width + 2 * border, image.height + 2 * border));
  if (cairo_surface_status(result.surface.get()) != CAIRO_STATUS_SUCCESS) return result;
  copy_pixels(image, border, kind, result.surface.get());
  // cairo looks through the pixels once a triangle until one is neither opaque nor clear. A faint
  // one in the corner, which the border keeps out of sight, makes that short.
  if (format == CAIRO_FORMAT_ARGB32)
    std::fill_n(cairo_image_surface_get_data(result.surface.get()), 4, std::uint8_t{1});
  cairo_surface_mark_dirty(result.surface.get());
  return result;
}

}  // namespace

VectorImage vector_image(const Image& image, const Box& place, const Box& rest_box) {
  constexpr double kWidest = 64;  // pixels of the border
  const glm::dvec2 size(image.width, image.height);
  const glm::dvec2 pixel = (place.max - place.min) / size;
  const glm::dvec2 out = glm::max(place.min - rest_box.min, rest_box.max - place.max) / pixel;
  const double most = std::max(std::max(out.x, out.y), 0.0);
  const double border = std::ceil(std::isfinite(most) ? std::min(most, kWidest) : 0) + 1;
  return with_border(image, place, static_cast<int>(border), ImageBorder::repeated);
}

VectorImage vector_piece(const Image& image, const Box& place) {
  return with_border(image, place, 1, ImageBorder::clear);
}

void fill_with_board(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                     const VectorBoard& board) {
  const PaintedInTurn painted(mesh, mesh.sheets);
  for (const int t : mesh.triangles_of(sheet))
    for (Polygon& piece : painted.pieces_of(t)) add_polygon(pane, std::move(piece));
  set_colour(pane, board.light);
  cairo_fill(pane.cairo);

  const glm::dvec2 extent = mesh.rest_box.max - mesh.rest_box.min;
  const double square = std::max(extent.x, extent.y) / board.squares;
  const AffineMap to_rest{glm::dmat2(square), mesh.rest_box.min};
  const Box whole_board{{-1, -1}, extent / square + 1.0};
  const Box seen = seen_box(pane);
  // Over sheets behind this one too: else light squares would lie on the soft edge of dark ones.
  const auto is_other_sheet = [&mesh](std::size_t t, std::size_t other) {
    return mesh.sheets[other] != mesh.sheets[t];
  };
  for (const int t : mesh.triangles_of(sheet)) {
    const AffineMap to_pane = composed(rest_to_pane(mesh, t), to_rest);
    const glm::dmat2 inverse = glm::inverse(to_pane.linear);
    const AffineMap to_squares{inverse, -(inverse * to_pane.offset)};
    if (!is_finite(to_pane) || !is_finite(to_squares)) continue;
    for (const Polygon& piece : grown(mesh, t, is_other_sheet))
      if (may_meet(piece, seen))
        add_dark_parts(pane, clipped(piece, seen), {to_squares, to_pane}, whole_board);
  }
  set_colour(pane, board.dark);
  cairo_fill(pane.cairo);
}

void fill_with_images(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                      std::span<const VectorImage> images) {
  std::vector<int> place_in_order(mesh.sheets.size());
  for (std::size_t k = 0; k < mesh.triangles.order.size(); ++k)
    place_in_order[static_cast<std::size_t>(mesh.triangles.order[k])] = static_cast<int>(k);
  const PaintedInTurn painted(mesh, place_in_order);
  for (const int t : mesh.triangles_of(sheet)) {
    const auto part = static_cast<std::size_t>(mesh.parts[static_cast<std::size_t>(t)]);
    // One picture serves all parts.
    const VectorImage& image = images.size() == 1 ? images.front() : images[part];
    if (!image.surface) continue;
    const AffineMap map = composed(rest_to_pane(mesh, t), image_to_rest(image));
    if (!is_finite(map) || glm::determinant(map.linear) == 0) continue;
    if (!may_meet(corners_in_pane(mesh, t), seen_box(pane))) continue;
    cairo_save(pane.cairo);
    for (Polygon& piece : painted.pieces_of(t)) add_polygon(pane, std::move(piece));
    cairo_clip(pane.cairo);
    const cairo_matrix_t matrix{map.linear[0].x, map.linear[0].y, map.linear[1].x,
                                map.linear[1].y, map.offset.x,    map.offset.y};
    cairo_transform(pane.cairo, &matrix);
    cairo_set_source_surface(pane.cairo, image.surface.get(), 0, 0);
    cairo_paint(pane.cairo);
    cairo_restore(pane.cairo);
  }
}

void fill_with_heat(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                    const Distortion& distortion) {
  const auto shade_of = [&](std::size_t t) {
    const double place = position_on(distortion.range, distortion.values[t]);
    return static_cast<int>(std::lround(place * (kShades - 1)));
  };
  // What is painted later has the larger number: by sheet, then by shade.
  std::vector<int> groups(mesh.sheets.size());
  for (std::size_t t = 0; t < groups.size(); ++t)
    groups[t] = mesh.sheets[t] * kShades + shade_of(t);
  const PaintedInTurn painted(mesh, groups);
  const std::span<const int> triangles = mesh.triangles_of(sheet);
  std::vector<int> order(triangles.begin(), triangles.end());
  const auto group_of = [&](int t) { return groups[static_cast<std::size_t>(t)]; };
  std::ranges::stable_sort(order, {}, group_of);
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (Polygon& piece : painted.pieces_of(order[k])) add_polygon(pane, std::move(piece));
    if (k + 1 < order.size() && group_of(order[k + 1]) == group_of(order[k])) continue;
    const int shade = shade_of(static_cast<std::size_t>(order[k]));
    set_colour(pane, {viridis(static_cast<float>(shade) / (kShades - 1)), 1});
    cairo_fill(pane.cairo);
  }
}

void fill_folded(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                 const glm::vec4& colour) {
  for (const int t : mesh.triangles_of(sheet)) {
    const auto [a, b, c] = corners_of(mesh, mesh.places, t);
    const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    // Counter-clockwise ones turn the other way where y points down.
    if (turn > 0) add_polygon(pane, {a, b, c});
  }
  set_colour(pane, colour);
  cairo_fill(pane.cairo);
}

}  // namespace foldless
