// SPDX-License-Identifier: GPL-3.0-or-later
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/files/atomic_file.h"
#include "core/scene/animation_json.h"
#include "core/scene/handle_kind.h"
#include "core/scene/json_node.h"
#include "core/scene/json_object.h"
#include "core/scene/parameter_keys.h"
#include "core/scene/parts_json.h"
#include "core/scene/rig_json.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

JsonNode point_node(const Vec2& p) { return {array_of(JsonNode{p.x()}, JsonNode{p.y()})}; }

JsonNode points_node(const Points& points) {
  JsonNode::Array array;
  array.reserve(static_cast<std::size_t>(points.cols()));
  for (const auto& p : points.colwise()) array.push_back(point_node(p));
  return {std::move(array)};
}

JsonNode triangles_node(const Triangles& triangles) {
  JsonNode::Array array;
  array.reserve(static_cast<std::size_t>(triangles.cols()));
  for (const auto& t : triangles.colwise()) {
    JsonNode::Array corners;
    for (const int v : t) corners.push_back({static_cast<double>(v)});
    array.push_back({std::move(corners)});
  }
  return {std::move(array)};
}

JsonNode mesh_node(const Scene& scene, const std::string& path) {
  if (!path.empty()) return {path};
  return {object_of(JsonMember("vertices", points_node(scene.rest)),
                    JsonMember("triangles", triangles_node(scene.triangles)))};
}

JsonNode stiffness_node(const Stiffness& stiffness) {
  JsonNode::Array array;
  for (const StiffStroke& stroke : stiffness.strokes()) {
    JsonNode::Object object;
    if (stroke.line.cols() == 1)
      object.emplace_back("center", point_node(stroke.line.col(0)));
    else
      object.emplace_back("line", points_node(stroke.line));
    object.emplace_back("radius", JsonNode{stroke.radius});
    object.emplace_back("factor", JsonNode{stroke.factor});
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

JsonNode handles_node(const std::vector<Handle>& handles) {
  JsonNode::Array array;
  for (const Handle& handle : handles) {
    JsonNode::Object object = object_of(JsonMember("vertex", {static_cast<double>(handle.vertex)}),
                                        JsonMember("target", point_node(handle.target)));
    if (handle.id != static_cast<int>(array.size()))
      object.emplace_back("id", JsonNode{static_cast<double>(handle.id)});
    if (handle.kind != HandleKind::drag)
      object.emplace_back("kind", JsonNode{std::string(handle_kind_name(handle.kind))});
    if (handle.weight != 1) object.emplace_back("weight", JsonNode{handle.weight});
    if (handle.depth != 0) object.emplace_back("depth", JsonNode{handle.depth});
    if (handle.turn) object.emplace_back("angle", JsonNode{handle.turn->angle});
    if (handle.turn) object.emplace_back("radius", JsonNode{handle.turn->radius});
    if (handle.stiff)
      object.emplace_back("stiff",
                          JsonNode{object_of(JsonMember("factor", {handle.stiff->factor}),
                                             JsonMember("radius", {handle.stiff->radius}))});
    if (!handle.name.empty()) object.emplace_back("name", JsonNode{handle.name});
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

JsonNode parameter_node(const ParameterKey& key, double value) {
  if (key.kind == ParameterKind::flag) return {value != 0};
  if (key.kind == ParameterKind::word)
    return {std::string(key.words[static_cast<std::size_t>(value)])};
  return {value};
}

JsonNode solver_node(const Parameters& parameters) {
  const Parameters defaults;
  JsonNode::Object object;
  if (parameters.method != defaults.method)
    object.emplace_back("method", JsonNode{parameters.method});
  for (const ParameterKey& key : parameter_keys()) {
    const auto value = key.get(parameters);
    if (value == key.get(defaults)) continue;
    object.emplace_back(key.name, parameter_node(key, *value));
  }
  return {std::move(object)};
}

JsonNode state_node(const Scene& scene) {
  JsonNode::Object object;
  if (scene.state) {
    object.emplace_back("triangles", triangles_node(scene.state->triangles));
    object.emplace_back("rest", points_node(scene.state->rest));
    object.emplace_back("deformed", points_node(scene.state->deformed));
  }
  if (scene.view) object.emplace_back("view", from_library(*scene.view));
  return {std::move(object)};
}

/// A path that leads from one folder to where it led from another; absolute paths stay, and so do
/// those of a scene that has no folder yet.
std::string path_from(const fs::path& new_folder, const std::string& path,
                      const fs::path& old_folder) {
  if (path.empty() || old_folder.empty() || fs::path(path).is_absolute()) return path;
  std::error_code ignored;
  const fs::path from = fs::weakly_canonical(old_folder, ignored);
  const fs::path to = fs::weakly_canonical(new_folder, ignored);
  if (from == to) return path;
  return (from / path).lexically_normal().lexically_relative(to).generic_string();
}

}  // namespace

std::string scene_text(const Scene& scene, const fs::path& folder) {
  assert(scene.energy);
  JsonNode::Object root = object_of(JsonMember("version", {static_cast<double>(kSceneVersion)}));
  if (!scene.description.empty()) root.emplace_back("description", JsonNode{scene.description});
  root.emplace_back("mesh", mesh_node(scene, path_from(folder, scene.mesh_path, scene.folder)));
  const std::string texture = path_from(folder, scene.texture_path, scene.folder);
  if (!texture.empty()) root.emplace_back("texture", JsonNode{texture});
  if (const auto& box = scene.texture_box)
    root.emplace_back("texture_box",
                      JsonNode{array_of(point_node(box->min), point_node(box->max))});
  if (scene.parts) root.emplace_back("parts", parts_node(*scene.parts));
  root.emplace_back("energy", JsonNode{std::string(scene.energy->name)});
  if (scene.stiffness) root.emplace_back("stiffness", stiffness_node(*scene.stiffness));
  root.emplace_back("handles", handles_node(scene.handles));
  if (!scene.rig.bones.empty()) root.emplace_back("bones", bones_node(scene.rig.bones));
  if (scene.rig.mirror) root.emplace_back("mirror", mirror_node(*scene.rig.mirror));
  if (scene.animation) root.emplace_back("animation", animation_node(*scene.animation));
  root.emplace_back("solver", solver_node(scene.parameters));
  if (scene.state || scene.view) root.emplace_back("state", state_node(scene));
  return json_text({std::move(root)});
}

void save_scene(const Scene& scene, const fs::path& file) {
  write_file_atomically(file, scene_text(scene, fs::absolute(file).parent_path()));
}

void move_to_folder(Scene& scene, const fs::path& folder) {
  scene.mesh_path = path_from(folder, scene.mesh_path, scene.folder);
  scene.texture_path = path_from(folder, scene.texture_path, scene.folder);
  scene.folder = folder;
}

}  // namespace foldless
