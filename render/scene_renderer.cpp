// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene_renderer.h"

#include "core/data_path.h"
#include "render/draw_state.h"
#include "render/edge_lines.h"
#include "render/fill_layer.h"
#include "render/line_layer.h"
#include "render/marker_layer.h"
#include "render/mesh_layer.h"
#include "render/theme.h"
#include "render/wire_layer.h"

namespace foldless {
struct SceneRenderer::Parts {
  explicit Parts(const std::filesystem::path& shader_folder)
      : lines(shader_folder), wire(shader_folder), fill(shader_folder), markers(shader_folder) {}

  void draw_rest(const Frame& frame, const ViewOptions& options) const;
  void prepare_heat(const Snapshot& snapshot, const SceneView& view, const ViewOptions& options);
  void draw_inside(const Frame& frame, std::size_t sheet, const ViewOptions& options) const;
  void draw_edges(const Frame& frame, std::size_t sheet, const ViewOptions& options) const;

  MeshLayer mesh;
  LineLayer lines;
  WireLayer wire;
  FillLayer fill;
  MarkerLayer markers;
  std::optional<HeatRange> heat_range;
};

void SceneRenderer::Parts::draw_rest(const Frame& frame, const ViewOptions& options) const {
  lines.begin(frame, rest_outline(options));
  mesh.draw_rest_boundary();
}

void SceneRenderer::Parts::prepare_heat(const Snapshot& snapshot, const SceneView& view,
                                        const ViewOptions& options) {
  heat_range.reset();
  const auto distortion = heat_of(snapshot, view.energy_densities, options);
  if (!distortion) return;
  heat_range = distortion->range;
  fill.upload_heat(mesh, *distortion);
}

void SceneRenderer::Parts::draw_inside(const Frame& frame, std::size_t sheet,
                                       const ViewOptions& options) const {
  const CanvasColours& colours = canvas_colours(options.theme);
  if (heat_range) {
    fill.draw_heat(frame, mesh, sheet);
  } else if (options.layers.fill) {
    fill.draw(frame, mesh, sheet,
              {colours.checker_light, colours.checker_dark, options.checker_squares});
  }
}

void SceneRenderer::Parts::draw_edges(const Frame& frame, std::size_t sheet,
                                      const ViewOptions& options) const {
  for (const EdgeLines& edges : edge_lines(options)) {
    if (edges.set == EdgeSet::interior) {
      wire.draw(frame, mesh, sheet, edges.style);
    } else {
      lines.begin(frame, edges.style);
      mesh.draw_edges(edges.set, sheet);
    }
  }
}

SceneRenderer::SceneRenderer(const std::filesystem::path& shader_folder)
    : parts_(
          std::make_unique<Parts>(shader_folder.empty() ? data_path("shaders") : shader_folder)) {}

SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

void SceneRenderer::set_texture(const TexturePieces& pieces, const std::optional<Box>& place) {
  begin_texture(pieces, place);
  upload_texture();
}

void SceneRenderer::begin_texture(const TexturePieces& pieces, const std::optional<Box>& place) {
  parts_->fill.set_texture(pieces, place);
}

bool SceneRenderer::upload_texture(std::size_t pixels) {
  return parts_->fill.upload_texture(pixels) > 0;
}

bool SceneRenderer::has_whole_texture() const { return parts_->fill.has_whole_texture(); }

void SceneRenderer::set_texture(const Image& image, const std::optional<Box>& place) {
  set_texture(*whole_texture(image), place);
}

void SceneRenderer::clear_texture() { parts_->fill.set_texture({}); }

void SceneRenderer::set_parts(std::shared_ptr<const MeshParts> parts) {
  parts_->mesh.set_parts(std::move(parts));
}

void SceneRenderer::draw(const Snapshot& snapshot, const SceneView& view,
                         const ViewOptions& options) {
  const DrawState state(view.viewport);
  const CanvasColours& colours = canvas_colours(options.theme);
  if (options.background == Background::theme) clear_canvas(colours.background);
  if (options.background == Background::transparent) clear_canvas(glm::vec4(0));
  if (!snapshot.triangles || !snapshot.rest) return;

  parts_->mesh.update(snapshot, options.pose);
  const glm::dvec2 viewport(view.viewport.width, view.viewport.height);
  const Frame frame{clip_transform(view.camera, viewport, parts_->mesh.local()), viewport,
                    static_cast<float>(options.ui_scale)};
  const MarkerScene scene{snapshot, view, options, parts_->mesh.local()};
  if (options.layers.rest && options.pose != Pose::rest) parts_->draw_rest(frame, options);
  parts_->prepare_heat(snapshot, view, options);
  if (options.layers.wireframe) parts_->wire.upload(parts_->mesh);
  if (!view.stiffness.empty()) parts_->fill.upload_stiffness(parts_->mesh, view.stiffness);
  // Whatever layers are on: a map that is not valid shows it.
  const bool shows_folds = snapshot.folded_triangles > 0 && options.pose == Pose::deformed;
  std::vector<std::vector<int>> vertices;
  if (options.layers.remeshed) vertices = parts_->mesh.sheet_vertices();
  for (std::size_t sheet = 0; sheet < parts_->mesh.sheet_count(); ++sheet) {
    parts_->draw_inside(frame, sheet, options);
    if (shows_folds) parts_->fill.draw_folded(frame, parts_->mesh, sheet, colours.folded);
    if (!view.stiffness.empty()) parts_->fill.draw_stiffness(frame, parts_->mesh, sheet);
    parts_->draw_edges(frame, sheet, options);
    if (options.layers.remeshed) parts_->markers.draw_split_vertices(frame, scene, vertices[sheet]);
  }
  if (options.layers.handles) parts_->markers.draw_handles(frame, scene, parts_->lines);
}

const std::optional<HeatRange>& SceneRenderer::heat_range() const { return parts_->heat_range; }

const RenderStats& SceneRenderer::stats() const { return parts_->mesh.stats(); }

}  // namespace foldless
