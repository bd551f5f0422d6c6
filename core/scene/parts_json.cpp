// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/parts_json.h"
#include "core/scene/json_object.h"

#include <string>
#include <utility>

namespace foldless {
namespace {

MeshPart read_part(const JsonValue& item, int first_vertex, int vertices) {
  item.allow_only({"layer", "vertex", "vertices", "depth"});
  MeshPart part;
  part.layer = item.at("layer").text();
  part.first_vertex = item.at("vertex").integer();
  part.vertices = item.at("vertices").integer();
  if (const auto depth = item.find("depth")) part.depth = depth->number();
  if (part.first_vertex != first_vertex)
    item.at("vertex").refuse("is " + item.at("vertex").shown() + ", but the next part begins at " +
                             std::to_string(first_vertex));
  if (part.vertices < 3 || part.vertices > vertices - first_vertex)
    item.at("vertices")
        .refuse("is " + item.at("vertices").shown() + ", but 3 to " +
                std::to_string(vertices - first_vertex) + " are possible");
  return part;
}

/// By vertex.
std::vector<std::size_t> owners_of(const MeshParts& parts) {
  std::vector<std::size_t> owners;
  for (std::size_t p = 0; p < parts.size(); ++p)
    owners.insert(owners.end(), static_cast<std::size_t>(parts[p].vertices), p);
  return owners;
}

}  // namespace

MeshParts read_parts(const JsonValue& parts, const Triangles& triangles, int vertices) {
  MeshParts result;
  int next = 0;
  for (const JsonValue& item : parts.items()) {
    result.push_back(read_part(item, next, vertices));
    next += result.back().vertices;
  }
  if (next != vertices)
    parts.refuse("have " + std::to_string(next) + " vertices, but the mesh has " +
                 std::to_string(vertices));
  const std::vector<std::size_t> owners = owners_of(result);
  const auto owner = [&](int v) { return owners[static_cast<std::size_t>(v)]; };
  for (const auto& t : triangles.colwise())
    if (owner(t[0]) != owner(t[1]) || owner(t[0]) != owner(t[2]))
      parts.refuse("are not apart: a triangle lies in '" + result[owner(t[0])].layer +
                   "' and in another");
  return result;
}

JsonNode parts_node(const MeshParts& parts) {
  JsonNode::Array array;
  for (const MeshPart& part : parts) {
    JsonNode::Object object =
        object_of(JsonMember("layer", JsonNode{part.layer}),
                  JsonMember("vertex", {static_cast<double>(part.first_vertex)}),
                  JsonMember("vertices", {static_cast<double>(part.vertices)}));
    if (part.depth != 0) object.emplace_back("depth", JsonNode{part.depth});
    array.push_back({std::move(object)});
  }
  return {std::move(array)};
}

}  // namespace foldless
