// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_figure.h"

#include <algorithm>
#include <cctype>

#include "app/export/vector_file.h"
#include "app/export/vector_fill.h"
#include "app/export/vector_legend.h"
#include "app/export/vector_lines.h"
#include "app/export/vector_markers.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "render/distortion.h"
#include "render/edge_lines.h"
#include "render/figure_panes.h"
#include "render/markers.h"
#include "render/theme.h"

namespace foldless {
namespace {

constexpr int kMostPixels = 16384;  // a side, as of pictures

/// Draws the panes of one figure.
class FigureDrawing {
 public:
  FigureDrawing(cairo_t* cairo, const Snapshot& snapshot, const FigureOptions& options)
      : cairo_(cairo), snapshot_(snapshot), options_(options) {}

  void draw() {
    draw_ground();
    if (!snapshot_.triangles || !snapshot_.rest) return;
    heat_ = heat_of(snapshot_, options_.energy_densities, options_.style);
    for (const FigurePane& pane : figure_panes(snapshot_, options_)) draw_pane(pane);
    if (!heat_ || !options_.has_legend) return;
    const auto legend = legend_of(options_.width, options_.height, heat_->range, options_.style);
    if (legend) draw_legend(whole(), *legend);
  }

 private:
  VectorPane whole() const {
    return {cairo_, glm::dvec2(options_.width, options_.height), options_.style.ui_scale};
  }

  void draw_ground() const {
    glm::vec4 colour = canvas_colours(options_.style.theme).background;
    if (const auto& ground = options_.ground)
      colour = glm::vec4((*ground)[0], (*ground)[1], (*ground)[2], 255) / 255.0F;
    else if (options_.style.background == Background::transparent)
      return;
    set_colour(whole(), colour);
    cairo_paint(cairo_);
  }

  void draw_pane(const FigurePane& figure_pane) {
    const Viewport& viewport = figure_pane.viewport;
    const VectorPane pane{cairo_, {viewport.width, viewport.height}, figure_pane.style.ui_scale};
    cairo_save(cairo_);
    cairo_translate(cairo_, viewport.x, options_.height - viewport.y - viewport.height);
    cairo_rectangle(cairo_, 0, 0, viewport.width, viewport.height);
    cairo_clip(cairo_);
    draw_mesh(pane, figure_pane);
    cairo_restore(cairo_);
  }

  void draw_mesh(const VectorPane& pane, const FigurePane& figure_pane) {
    const ViewOptions& style = figure_pane.style;
    const MeshView mesh_view{style.pose, figure_pane.camera, pane.size, options_.parts};
    const PlacedMesh mesh = placed_mesh(snapshot_, mesh_view);
    if (style.layers.rest && style.pose != Pose::rest)
      draw_outline(
          pane, placed_mesh(snapshot_, {Pose::rest, figure_pane.camera, pane.size, options_.parts}),
          rest_outline(style));
    const glm::dvec2 extent = mesh.rest_box.max - mesh.rest_box.min;
    const LocalFrame local{mesh.rest_box.min, std::max(extent.x, extent.y)};
    const SceneView view{.viewport = figure_pane.viewport, .camera = figure_pane.camera};
    const MarkerScene scene{snapshot_, view, style, local};
    std::vector<std::vector<int>> vertices;
    if (style.layers.remeshed) vertices = vertices_by_sheet(mesh.corners, mesh.sheets);
    for (std::size_t sheet = 0; sheet < mesh.sheet_count(); ++sheet) {
      fill_sheet(pane, mesh, sheet, style);
      draw_edges(pane, mesh, sheet, style);
      if (style.layers.remeshed) draw_markers(pane, scene, split_markers(scene, vertices[sheet]));
    }
    if (style.layers.handles) draw_handles(pane, scene);
  }

  void fill_sheet(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                  const ViewOptions& style) {
    const CanvasColours& colours = canvas_colours(style.theme);
    if (style.layers.heat && heat_) {
      fill_with_heat(pane, mesh, sheet, *heat_);
    } else if (style.layers.fill && has_image()) {
      if (images_.empty()) read_images(mesh.rest_box);
      fill_with_images(pane, mesh, sheet, images_);
    } else if (style.layers.fill) {
      fill_with_board(pane, mesh, sheet,
                      {colours.checker_light, colours.checker_dark, style.checker_squares});
    }
    // Whatever layers are on: a map that is not valid shows it.
    if (snapshot_.folded_triangles > 0 && style.pose == Pose::deformed)
      fill_folded(pane, mesh, sheet, colours.folded);
  }

  bool has_image() const { return options_.texture && !options_.texture->empty(); }

  void read_images(const Box& rest_box) {
    const Box place = options_.texture_place.value_or(rest_box);
    const glm::dvec2 size = place.max - place.min;
    for (const TexturePiece& piece : *options_.texture) {
      const Box within{place.min + piece.within.min * size, place.min + piece.within.max * size};
      const bool is_seen = piece.levels && !piece.levels->empty();
      if (!is_seen)
        images_.emplace_back();
      else if (piece.within == Box{})
        images_.push_back(vector_image(piece.levels->front(), within, rest_box));
      else
        images_.push_back(vector_piece(piece.levels->front(), within));
    }
  }

  cairo_t* cairo_;
  const Snapshot& snapshot_;
  const FigureOptions& options_;
  std::optional<Distortion> heat_;
  std::vector<VectorImage> images_;  ///< of all panes, so that each is embedded once
};

}  // namespace

std::optional<VectorFormat> vector_format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".svg") return VectorFormat::svg;
  if (extension == ".pdf") return VectorFormat::pdf;
  return std::nullopt;
}

std::string vector_figure(VectorFormat format, const Snapshot& snapshot,
                          const FigureOptions& options, const ImageTexts& texts) {
  if (std::max(options.width, options.height) > kMostPixels)
    throw Error("a figure of " + std::to_string(options.width) + " × " +
                std::to_string(options.height) + " pixels is too large; a side has at most " +
                std::to_string(kMostPixels));
  VectorFile file(format, options.width, options.height);
  FigureDrawing(file.cairo(), snapshot, options).draw();
  return file.finish(texts);
}

void save_vector_figure(const std::filesystem::path& file, const Snapshot& snapshot,
                        const FigureOptions& options, const ImageTexts& texts) {
  const VectorFormat format = vector_format_of(file).value_or(VectorFormat::svg);
  write_file_atomically(file, vector_figure(format, snapshot, options, texts));
}

}  // namespace foldless
