// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/scene_document.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace foldless {
namespace {

using nlohmann::json;

/// The number under a key when it is there, finite and within bounds.
std::optional<double> number(const json& object, const char* key, double minimum, double maximum) {
  const auto it = object.find(key);
  if (it == object.end() || !it->is_number()) return std::nullopt;
  const double value = it->get<double>();
  if (!(value >= minimum && value <= maximum)) return std::nullopt;
  return value;
}

constexpr std::array kHeatMeasures{"conformal", "area", "energy"};  // in the order of HeatMeasure

constexpr double kFar = 1e300;

bool read_camera(const json& view, Camera& camera) {
  const auto it = view.find("camera");
  if (it == view.end() || !it->is_object()) return false;
  const auto x = number(*it, "x", -kFar, kFar);
  const auto y = number(*it, "y", -kFar, kFar);
  const auto scale = number(*it, "pixels_per_unit", 1e-120, 1e120);
  if (!x || !y || !scale) return false;
  camera = {{*x, *y}, *scale};
  return true;
}

}  // namespace

Document document_of(const Scene& scene, const std::filesystem::path& file) {
  Document document = document_of(Shape{scene.triangles, scene.rest}, file.stem().string());
  if (scene.state)
    document.pose =
        pose_of(MeshPair(scene.state->triangles, scene.state->rest, scene.state->deformed),
                *document.original);
  document.handles = scene.handles;
  for (const Handle& handle : scene.handles)
    if (handle.id < std::numeric_limits<int>::max())
      document.next_handle_id = std::max(document.next_handle_id, handle.id + 1);
  document.rig = scene.rig;
  document.animation = scene.animation;
  document.energy = scene.energy;
  document.stiffness = scene.stiffness;
  document.parameters = scene.parameters;
  if (!scene.mesh_path.empty())
    document.mesh_file = (scene.folder / scene.mesh_path).lexically_normal();
  if (!scene.texture_path.empty())
    document.texture = (scene.folder / scene.texture_path).lexically_normal();
  document.texture_box = scene.texture_box;
  document.parts = scene.parts;
  document.description = scene.description;
  return document;
}

Scene scene_of(const Document& document, const std::filesystem::path& file,
               std::shared_ptr<const json> view) {
  Scene scene;
  scene.folder = std::filesystem::absolute(file).lexically_normal().parent_path();
  scene.triangles = document.original->triangles;
  scene.rest = document.original->rest;
  if (!document.texture.empty())
    scene.texture_path = document.texture.lexically_proximate(scene.folder).generic_string();
  scene.texture_box = document.texture_box;
  scene.parts = document.parts;
  scene.energy = document.energy;
  scene.stiffness = document.stiffness;
  scene.handles = document.handles;
  scene.rig = document.rig;
  scene.animation = document.animation;
  scene.parameters = document.parameters;
  const Snapshot& pose = *document.pose;
  scene.state = SceneState{*pose.triangles, *pose.rest, pose.deformed};
  scene.view = std::move(view);
  scene.description = document.description;
  return scene;
}

json layers_json(const Layers& layers) {
  json names = json::array();
  for (const LayerRow& row : kLayerRows)
    if (layers.*row.shown) names.push_back(row.name);
  return names;
}

Layers read_layers(const json& names, const Layers& otherwise) {
  if (!names.is_array()) return otherwise;
  Layers layers;
  for (const LayerRow& row : kLayerRows)
    layers.*row.shown = std::find(names.begin(), names.end(), json(row.name)) != names.end();
  return layers;
}

json view_json(const Camera& camera, const ViewOptions& options) {
  return {{"camera",
           {{"x", camera.centre.x},
            {"y", camera.centre.y},
            {"pixels_per_unit", camera.pixels_per_unit}}},
          {"layers", layers_json(options.layers)},
          {"checker_squares", options.checker_squares},
          {"heat_measure", kHeatMeasures[static_cast<std::size_t>(options.heat_measure)]}};
}

bool read_view(const json& view, Camera& camera, ViewOptions& options) {
  if (!view.is_object()) return false;
  if (const auto it = view.find("layers"); it != view.end())
    options.layers = read_layers(*it, options.layers);
  if (const auto squares = number(view, "checker_squares", 1, 1e4))
    options.checker_squares = *squares;
  if (const auto it = view.find("heat_measure"); it != view.end())
    for (std::size_t i = 0; i < kHeatMeasures.size(); ++i)
      if (*it == kHeatMeasures[i]) options.heat_measure = static_cast<HeatMeasure>(i);
  return read_camera(view, camera);
}

}  // namespace foldless
