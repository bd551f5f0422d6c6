// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/godot.h"

#include <algorithm>

#include "app/export/engine_mesh.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

/// A string of the format.
std::string godot_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// A name that a node may have.
std::string node_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return std::string_view(".:@/\"%").find(c) != std::string_view::npos; },
      '_');
  return name.empty() ? "Animation" : name;
}

std::string piece_name(std::size_t piece) { return "Piece" + std::to_string(piece + 1); }

template <typename Numbers>
void append_packed(std::string& text, const char* type, const Numbers& numbers) {
  text.append(type).append("(");
  bool is_first = true;
  for (const auto number : numbers) {
    if (!is_first) text += ", ";
    is_first = false;
    append_number(text, number);
  }
  text += ')';
}

/// With y down. A difference to 0, so that there is no -0.
void append_polygon(std::string& text, const EngineMesh& mesh, const Points& points) {
  std::vector<double> places;
  for (const int v : mesh.vertices) {
    places.push_back(points(0, v));
    places.push_back(0 - points(1, v));
  }
  append_packed(text, "PackedVector2Array", places);
}

/// Pixels of the picture from its upper left corner.
void append_uv(std::string& text, const BakedAnimation& animation, const EngineMesh& mesh,
               const GltfPiece& piece) {
  std::vector<double> places;
  const auto& [min, max] = piece.place;
  for (const int v : mesh.vertices) {
    const Vec2 p = animation.rest.col(v);
    places.push_back(piece.image.width * (p.x() - min.x) / (max.x - min.x));
    places.push_back(piece.image.height * (max.y - p.y()) / (max.y - min.y));
  }
  append_packed(text, "PackedVector2Array", places);
}

void append_node(std::string& text, const BakedAnimation& animation, const EngineMesh& mesh,
                 const GltfPiece& piece) {
  text += "polygon = ";
  append_polygon(text, mesh, animation.frames.front().deformed);
  text += "\nuv = ";
  append_uv(text, animation, mesh, piece);
  text += "\npolygons = [";
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    if (t > 0) text += ", ";
    append_packed(text, "PackedInt32Array", mesh.triangles.col(t));
  }
  text += "]\ninternal_vertex_count = ";
  append_number(text, static_cast<int>(mesh.vertices.size()) - mesh.hull);
  text += '\n';
}

/// The exponents of the time's share of the way to the next key; with 0 a value stays until then.
std::vector<int> transitions(std::size_t keys, const HeldSteps& held) {
  std::vector<int> exponents(keys, 1);
  for (const std::size_t step : held)
    if (step < keys) exponents[step] = 0;
  return exponents;
}

/// What runs, and where it stands still.
struct HeldAnimation {
  const BakedAnimation& animation;
  const HeldSteps& held;
};

/// A value track: what runs continuously and linearly from key to key.
void append_track(std::string& text, const HeldAnimation& running, const EngineMesh& mesh,
                  std::size_t piece) {
  const std::string track = "tracks/" + std::to_string(piece) + "/";
  const std::vector<double> times = key_times(running.animation);
  text.append(track).append("type = \"value\"\n").append(track).append("imported = false\n");
  text.append(track).append("enabled = true\n").append(track).append("path = NodePath(\"");
  text.append(piece_name(piece)).append(":polygon\")\n").append(track).append("interp = 1\n");
  text.append(track).append("loop_wrap = true\n").append(track).append("keys = {\n\"times\": ");
  append_packed(text, "PackedFloat32Array", times);
  text += ",\n\"transitions\": ";
  append_packed(text, "PackedFloat32Array", transitions(times.size(), running.held));
  text += ",\n\"update\": 0,\n\"values\": [";
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (k > 0) text += ", ";
    append_polygon(text, mesh, frame_of_key(running.animation, k));
  }
  text += "]\n}\n";
}

void append_animation(std::string& text, const HeldAnimation& running,
                      const std::vector<EngineMesh>& meshes, const std::string& name) {
  const BakedAnimation& animation = running.animation;
  text +=
      "[sub_resource type=\"Animation\" id=\"Animation_1\"]\nresource_name = " + godot_string(name);
  text += "\nlength = ";
  append_number(text, std::max(key_times(animation).back(), 1 / animation.fps));
  text.append("\nloop_mode = ").append(animation.loops ? "1" : "0").append("\nstep = ");
  append_number(text, 1 / animation.fps);
  text += '\n';
  for (std::size_t i = 0; i < meshes.size(); ++i) append_track(text, running, meshes[i], i);
  text += "\n[sub_resource type=\"AnimationLibrary\" id=\"AnimationLibrary_1\"]\n_data = {\n" +
          godot_string(name) + ": SubResource(\"Animation_1\")\n}\n\n";
}

}  // namespace

std::string godot_scene(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                        const std::string& name, const HeldSteps& held) {
  std::vector<EngineMesh> meshes;
  meshes.reserve(pieces.size());
  for (const GltfPiece& piece : pieces) meshes.push_back(engine_mesh(animation, piece.triangles));
  const std::string root = node_name(name);
  std::string text = "[gd_scene load_steps=" + std::to_string(pieces.size() + 3) + " format=3]\n\n";
  for (std::size_t i = 0; i < pieces.size(); ++i)
    text += "[ext_resource type=\"Texture2D\" path=" +
            godot_string(picture_name(name, i, pieces.size())) + " id=\"" + std::to_string(i + 1) +
            "\"]\n";
  text += '\n';
  append_animation(text, {animation, held}, meshes, root);
  text += "[node name=" + godot_string(root) + " type=\"Node2D\"]\n\n";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    text += "[node name=\"" + piece_name(i) +
            "\" type=\"Polygon2D\" parent=\".\"]\ntexture = ExtResource(\"" +
            std::to_string(i + 1) + "\")\n";
    append_node(text, animation, meshes[i], pieces[i]);
    text += '\n';
  }
  text += "[node name=\"AnimationPlayer\" type=\"AnimationPlayer\" parent=\".\"]\nlibraries = {\n" +
          std::string("\"\": SubResource(\"AnimationLibrary_1\")\n}\nautoplay = ") +
          godot_string(root) + "\n";
  return text;
}

}  // namespace foldless
