// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/energy/densities.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/files/polygon_soup.h"
#include "core/files/text_lines.h"
#include "core/files/validate.h"
#include "core/scene/animation_json.h"
#include "core/scene/inline_mesh.h"
#include "core/scene/json_value.h"
#include "core/scene/parameter_value.h"
#include "core/scene/parts_json.h"
#include "core/scene/read_handles.h"
#include "core/scene/rig_json.h"
#include "core/scene/scene_io.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDefaultEnergy = "arap";

/// True for pictures and the like: nothing that JSON allows, and no text of any kind, has such
/// characters.
bool is_binary(std::string_view text) {
  return text.substr(0, 64).find_first_of(
             std::string_view("\0\x1\x2\x3\x4\x5\x6\x7\x1a\xff", 10)) != text.npos;
}

/// Reads one scene file, key by key.
class SceneReader {
 public:
  SceneReader(const fs::path& file, std::span<const std::string_view> methods)
      : file_(file), name_(file.string()), methods_(methods.begin(), methods.end()) {}

  LoadedScene read() {
    if (is_mesh_file(file_)) throw Error(name_ + ": is a mesh, but a scene is needed");
    const std::string bytes = read_file(file_);
    if (is_binary(bytes)) throw Error(name_ + ": is no text, but a scene (JSON) is needed");
    const JsonNode node = parse_json(bytes, name_);
    const JsonValue root(node, name_);
    read_version(root);
    root.allow_only({"version", "description", "mesh", "texture", "texture_box", "parts", "energy",
                     "stiffness", "handles", "bones", "mirror", "animation", "solver", "state"});
    scene_.folder = fs::absolute(file_).parent_path();
    if (const auto text = root.find("description")) scene_.description = text->text();
    if (const auto path = root.find("texture")) scene_.texture_path = path->path();
    if (const auto box = root.find("texture_box")) scene_.texture_box = read_box(*box);
    scene_.energy = find_density(kDefaultEnergy);
    if (const auto energy = root.find("energy")) read_energy(*energy);
    if (const auto strokes = root.find("stiffness")) read_stiffness(*strokes);
    if (const auto solver = root.find("solver")) read_solver(*solver);
    read_mesh_of(root.at("mesh"));
    if (const auto parts = root.find("parts"))
      scene_.parts = std::make_shared<const MeshParts>(
          read_parts(*parts, scene_.triangles, static_cast<int>(scene_.rest.cols())));
    if (const auto state = root.find("state")) read_state(*state);
    if (const auto handles = root.find("handles"))
      scene_.handles = read_handles(*handles, used_vertices());
    if (const auto bones = root.find("bones"))
      scene_.rig.bones = read_bones(*bones, scene_.handles);
    if (const auto mirror = root.find("mirror")) scene_.rig.mirror = read_mirror(*mirror);
    if (const auto animation = root.find("animation"))
      scene_.animation =
          std::make_shared<const Animation>(read_animation(*animation, scene_.handles));
    return {std::move(scene_), std::move(notices_)};
  }

 private:
  void read_version(const JsonValue& root) const {
    const auto version = root.find("version");
    if (!version) return;
    const int number = version->integer();
    if (number > kSceneVersion)
      version->refuse("is " + version->shown() + ", but this program reads version " +
                      std::to_string(kSceneVersion) + "; use a newer Foldless");
    if (number < 1) version->refuse("is " + version->shown() + ", but versions begin with 1");
  }

  static TextureBox read_box(const JsonValue& value) {
    const Points corners = value.points();
    if (corners.cols() != 2 || !(corners.col(0).array() < corners.col(1).array()).all())
      value.refuse("is " + value.shown() +
                   ", but the lower left and the upper right corner are needed: [[x, y], [x, y]]");
    return {corners.col(0), corners.col(1)};
  }

  void read_energy(const JsonValue& energy) {
    scene_.energy = find_density(energy.text());
    if (scene_.energy) return;
    std::vector<std::string_view> names;
    for (const Density& density : densities()) names.push_back(density.name);
    energy.refuse("is " + energy.shown() + ", which is unknown; known are " + listed(names));
  }

  static Points middle_of_stroke(const JsonValue& stroke) {
    const auto line = stroke.find("line");
    if (!line) return stroke.at("center").point();
    if (stroke.find("center")) line->refuse("and 'center' exclude each other");
    Points points = line->points();
    if (points.cols() == 0) line->refuse("is empty, but points [[x, y], ...] are needed");
    return points;
  }

  void read_stiffness(const JsonValue& value) {
    std::vector<StiffStroke> strokes;
    for (const JsonValue& item : value.items()) {
      item.allow_only({"center", "line", "radius", "factor"});
      strokes.push_back({middle_of_stroke(item), item.at("radius").number_above_zero(),
                         item.at("factor").number()});
      const StiffStroke& stroke = strokes.back();
      if (!(stroke.factor >= kLeastStiffness && stroke.factor <= kLargestStiffness))
        item.at("factor").refuse("is " + item.at("factor").shown() +
                                 ", but a number from 0.001 to 1000000 is needed");
    }
    if (!strokes.empty()) scene_.stiffness = std::make_shared<const Stiffness>(std::move(strokes));
  }

  void read_solver(const JsonValue& solver) {
    std::vector<std::string_view> keys{"method"};
    for (const ParameterKey& key : parameter_keys()) keys.push_back(key.name);
    solver.allow_only(keys);
    if (const auto method = solver.find("method")) read_method(*method);
    for (const ParameterKey& key : parameter_keys())
      if (const auto value = solver.find(key.name))
        key.set(scene_.parameters, parameter_value(key, *value));
  }

  void read_method(const JsonValue& method) {
    if (std::ranges::find(methods_, method.text()) == methods_.end())
      method.refuse("is " + method.shown() + ", which is unknown; known are " + listed(methods_));
    scene_.parameters.method = method.text();
  }

  void read_mesh_of(const JsonValue& mesh) {
    if (mesh.node().as<std::string>()) {
      scene_.mesh_path = mesh.path();
      const fs::path found = file_.parent_path() / scene_.mesh_path;
      if (!fs::exists(found))
        mesh.refuse("is " + mesh.shown() + ", but there is no file " + found.string());
      LoadedMesh loaded = read_mesh(found);
      scene_.triangles = std::move(loaded.triangles);
      scene_.rest = std::move(loaded.points);
      notices_ = std::move(loaded.notices);
      return;
    }
    if (!mesh.node().as<JsonNode::Object>())
      mesh.refuse("is " + mesh.shown() +
                  ", but a path or an object of vertices and triangles is needed");
    mesh.allow_only({"vertices", "triangles"});
    TriangleSoup inline_mesh = validated(
        read_inline_triangles(mesh.at("vertices"), mesh.at("triangles"), name_, "mesh: "));
    scene_.triangles = std::move(inline_mesh.triangles);
    scene_.rest = std::move(inline_mesh.points);
    notices_ = std::move(inline_mesh.notices);
  }

  void read_state(const JsonValue& state) {
    state.allow_only({"triangles", "rest", "deformed", "view"});
    if (const auto view = state.find("view"))
      scene_.view = std::make_shared<const nlohmann::json>(to_library(view->node()));
    if (!state.find("triangles") && !state.find("rest") && !state.find("deformed")) return;
    const JsonValue triangles = state.at("triangles");
    const JsonValue deformed = state.at("deformed");
    TriangleSoup rest = read_inline_triangles(state.at("rest"), triangles, name_, "state.rest: ");
    check_vertex_counts(state.at("rest"), rest.points.cols(), deformed);
    TriangleSoup posed = read_inline_triangles(deformed, triangles, name_, "state.deformed: ");
    const int n = static_cast<int>(rest.points.cols());
    check_connectivity(rest.triangles, n, rest.source);
    check_positions(rest.triangles, rest.points, rest.source);
    check_positions(posed.triangles, posed.points, posed.source, BoundaryOverlaps::allowed);
    scene_.state =
        SceneState{std::move(rest.triangles), std::move(rest.points), std::move(posed.points)};
  }

  void check_vertex_counts(const JsonValue& rest, Eigen::Index rest_count,
                           const JsonValue& deformed) const {
    const Eigen::Index deformed_count = deformed.points().cols();
    if (deformed_count != rest_count)
      deformed.refuse("has " + std::to_string(deformed_count) + " vertices, but state.rest has " +
                      std::to_string(rest_count));
    if (rest_count < scene_.rest.cols())
      rest.refuse("has " + std::to_string(rest_count) + " vertices, but the mesh has " +
                  std::to_string(scene_.rest.cols()) +
                  "; the mesh may have been changed after the scene was saved");
  }

  std::vector<bool> used_vertices() const {
    const Triangles& triangles = scene_.state ? scene_.state->triangles : scene_.triangles;
    const Points& points = scene_.state ? scene_.state->rest : scene_.rest;
    std::vector<bool> used(static_cast<std::size_t>(points.cols()), false);
    for (const int v : triangles.reshaped()) used[static_cast<std::size_t>(v)] = true;
    return used;
  }

  const fs::path file_;
  const std::string name_;
  std::vector<std::string_view> methods_;
  Scene scene_;
  std::vector<std::string> notices_;
};

}  // namespace

LoadedScene load_scene(const fs::path& file, std::span<const std::string_view> methods) {
  return SceneReader(file, methods).read();
}

LoadedScene scene_from_mesh(const fs::path& file) {
  LoadedMesh mesh = read_mesh(file);
  Scene scene;
  scene.folder = fs::absolute(file).parent_path();
  scene.mesh_path = file.filename().string();
  scene.triangles = std::move(mesh.triangles);
  scene.rest = std::move(mesh.points);
  scene.energy = find_density(kDefaultEnergy);
  return {std::move(scene), std::move(mesh.notices)};
}

}  // namespace foldless
