// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/pictures.h"

#include <utility>

#include "app/export/vector_figure.h"
#include "core/api/point_map.h"
#include "core/error.h"
#include "core/outline/image_mesh.h"
#include "render/figure.h"

namespace foldless {
namespace {

MeshDetail detail_named(const std::string& name) {
  if (name == "coarse") return MeshDetail::coarse;
  if (name == "medium") return MeshDetail::medium;
  if (name == "fine") return MeshDetail::fine;
  throw Error("there is no detail '" + name + "'; choose one of: coarse, medium, fine");
}

FigureView view_named(const std::string& name) {
  if (name == "deformed") return FigureView::deformed;
  if (name == "rest") return FigureView::rest;
  if (name == "both") return FigureView::both;
  throw Error("there is no view '" + name + "'; choose one of: deformed, rest, both");
}

}  // namespace

PictureMesh mesh_of_picture(const std::filesystem::path& picture, const std::string& detail) {
  const MeshDetail chosen = detail_named(detail);
  const Image image = load_image(picture);
  const AlphaMap alpha{image.width, image.height, alpha_of(image)};
  try {
    const Shape shape = mesh_of_image(alpha, options_for(alpha, chosen))->shape;
    return {shape.rest.transpose(), shape.triangles.transpose()};
  } catch (const Error& error) {
    throw Error(picture.string() + ": " + error.what());
  }
}

void draw(const Result& result, const std::filesystem::path& picture, const DrawingOptions& how) {
  const bool is_vector = vector_format_of(picture).has_value();
  if (!is_vector && picture.extension() != ".png")
    throw Error(picture.string() +
                ": pictures are written as PNG, SVG or PDF; end the name with .png, .svg or .pdf");
  FigureOptions figure;
  figure.view = view_named(how.view);
  figure.width = how.width;
  figure.height = how.height;
  if (how.texture) {
    const Image image = load_image(*how.texture);
    figure.texture = load_texture(*how.texture, nullptr).pieces;
    figure.texture_place = Box{{0, 0}, {image.width, image.height}};
  }
  const Snapshot& snapshot = result.point_map->snapshot();
  const ImageTexts texts{{"Software", "Foldless"}};
  if (is_vector)
    save_vector_figure(picture, snapshot, figure, texts);
  else
    save_png(picture, render_figure(snapshot, figure), texts);
}

}  // namespace foldless
