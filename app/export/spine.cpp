// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/spine.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/export/engine_mesh.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

/// The format's: runtimes read files of their own major and minor number.
constexpr const char* kVersion = "4.2.43";

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// `"key":[0,1]`.
template <typename Numbers>
void append_list(std::string& text, const char* key, const Numbers& numbers) {
  text.append("\"").append(key).append("\":[");
  bool is_first = true;
  for (const auto number : numbers) {
    if (!is_first) text += ',';
    is_first = false;
    append_number(text, number);
  }
  text += ']';
}

/// x and y of one vertex after the other.
std::vector<double> places_of(const EngineMesh& mesh, const Points& points) {
  std::vector<double> places;
  places.reserve(2 * mesh.vertices.size());
  for (const int v : mesh.vertices) {
    places.push_back(points(0, v));
    places.push_back(points(1, v));
  }
  return places;
}

/// Where the picture is on each vertex; v from the top.
std::vector<double> places_on_picture(const BakedAnimation& animation, const EngineMesh& mesh,
                                      const Box& place) {
  std::vector<double> places;
  for (const int v : mesh.vertices) {
    const Vec2 p = animation.rest.col(v);
    places.push_back((p.x() - place.min.x) / (place.max.x - place.min.x));
    places.push_back((place.max.y - p.y()) / (place.max.y - place.min.y));
  }
  return places;
}

void append_attachment(std::string& text, const BakedAnimation& animation, const EngineMesh& mesh,
                       const GltfPiece& piece) {
  text += "{\"type\":\"mesh\",";
  append_list(text, "uvs", places_on_picture(animation, mesh, piece.place));
  text += ',';
  append_list(text, "triangles", mesh.triangles.reshaped());
  text += ',';
  append_list(text, "vertices", places_of(mesh, animation.frames.front().deformed));
  text += ",\"hull\":";
  append_number(text, mesh.hull);
  text += ',';
  std::vector<int> ends;  // Of edges, as places of x among x and y.
  for (const Edge& edge : mesh.edges) ends.insert(ends.end(), {2 * edge[0], 2 * edge[1]});
  append_list(text, "edges", ends);
  text += ",\"width\":";
  append_number(text, piece.image.width);
  text += ",\"height\":";
  append_number(text, piece.image.height);
  text += '}';
}

std::vector<double> differences(const std::vector<double>& places,
                                const std::vector<double>& first) {
  std::vector<double> by;
  for (std::size_t i = 0; i < places.size(); ++i) by.push_back(places[i] - first[i]);
  return by;
}

/// The differences to the first frame, without the zeros that they begin and end with.
void append_key(std::string& text, double time, const std::vector<double>& by, bool is_held) {
  const auto differs = [](double difference) { return difference != 0; };
  const auto begin = std::ranges::find_if(by, differs);
  const auto end = std::find_if(by.rbegin(), by.rend(), differs).base();
  text += "{\"time\":";
  append_number(text, time);
  if (begin < end) {
    text += ",\"offset\":";
    append_number(text, static_cast<int>(begin - by.begin()));
    text += ',';
    append_list(text, "vertices", std::vector<double>(begin, end));
  }
  if (is_held) text += ",\"curve\":\"stepped\"";
  text += '}';
}

void append_deform(std::string& text, const BakedAnimation& animation, const EngineMesh& mesh,
                   const HeldSteps& held) {
  const std::vector<double> first = places_of(mesh, animation.frames.front().deformed);
  const std::vector<double> times = key_times(animation);
  text += "{\"deform\":[";
  for (std::size_t k = 0; k < times.size(); ++k) {
    text += k == 0 ? "\n" : ",\n";
    const std::vector<double> places = places_of(mesh, frame_of_key(animation, k));
    append_key(text, times[k], differences(places, first), held.contains(k));
  }
  text += "]}";
}

/// `{"a":{"a":...},"b":{"b":...}}`: a slot and the attachment in it have the name of their piece.
template <typename Append>
void append_by_slot(std::string& text, const std::vector<std::string>& names,
                    const Append& append) {
  text += '{';
  for (std::size_t i = 0; i < names.size(); ++i) {
    text.append(i == 0 ? "" : ",\n").append(names[i]).append(":{").append(names[i]).append(":");
    append(i);
    text += '}';
  }
  text += '}';
}

/// The box of the first frame.
void append_skeleton(std::string& text, const Points& first) {
  const Vec2 least = first.rowwise().minCoeff(), most = first.rowwise().maxCoeff();
  text.append("\"skeleton\":{\"spine\":\"").append(kVersion).append("\",\"x\":");
  append_number(text, least.x());
  text += ",\"y\":";
  append_number(text, least.y());
  text += ",\"width\":";
  append_number(text, most.x() - least.x());
  text += ",\"height\":";
  append_number(text, most.y() - least.y());
  text += ",\"images\":\"./\"}";
}

/// The name of a piece's picture without its ending, which is that of its region of the atlas too.
std::string region_name(const std::string& name, std::size_t piece, std::size_t pieces) {
  const std::string picture = picture_name(name, piece, pieces);
  return picture.substr(0, picture.size() - 4);
}

}  // namespace

SpineText spine_text(const BakedAnimation& animation, const std::vector<GltfPiece>& pieces,
                     const std::string& name, const HeldSteps& held) {
  std::vector<EngineMesh> meshes;
  std::vector<std::string> names;
  SpineText result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    meshes.push_back(engine_mesh(animation, pieces[i].triangles));
    const std::string region = region_name(name, i, pieces.size());
    names.push_back(json_string(region));
    const std::string size =
        std::to_string(pieces[i].image.width) + "," + std::to_string(pieces[i].image.height);
    result.atlas.append(i > 0 ? "\n" : "")
        .append(region)
        .append(".png\nsize:")
        .append(size)
        .append("\nfilter:Linear,Linear\n")
        .append(region)
        .append("\nbounds:0,0,")
        .append(size)
        .append("\n");
  }
  std::string& text = result.json;
  text = "{";
  append_skeleton(text, animation.frames.front().deformed);
  text += ",\n\"bones\":[{\"name\":\"root\"}],\n\"slots\":[";
  for (std::size_t i = 0; i < names.size(); ++i)
    text.append(i == 0 ? "" : ",")
        .append("{\"name\":")
        .append(names[i])
        .append(",\"bone\":\"root\",\"attachment\":" + names[i] + "}");
  text += "],\n\"skins\":[{\"name\":\"default\",\"attachments\":";
  append_by_slot(text, names,
                 [&](std::size_t i) { append_attachment(text, animation, meshes[i], pieces[i]); });
  text += "}],\n\"animations\":{" + json_string(name) + ":{\"attachments\":{\"default\":";
  append_by_slot(text, names,
                 [&](std::size_t i) { append_deform(text, animation, meshes[i], held); });
  text += "}}}}\n";
  return result;
}

}  // namespace foldless
