// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/read_handles.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "core/mesh/stiffness.h"
#include "core/scene/handle_kind.h"

namespace foldless {
namespace {

using Ids = std::vector<std::optional<int>>;

int read_vertex(const JsonValue& value, const std::vector<bool>& used, std::vector<bool>& named) {
  const int vertex = value.integer();
  const auto v = static_cast<std::size_t>(vertex);
  if (vertex < 0 || v >= used.size())
    value.refuse("is " + value.shown() + ", but the vertices are 0 to " +
                 std::to_string(used.size() - 1));
  if (named[v]) value.refuse("is " + value.shown() + ", which an earlier handle names already");
  if (!used[v]) value.refuse("is " + value.shown() + ", a vertex that belongs to no triangle");
  named[v] = true;
  return vertex;
}

HandleKind read_kind(const JsonValue& value) {
  const auto kind = handle_kind(value.text());
  if (!kind) value.refuse("is " + value.shown() + ", but drag, pin or soft is needed");
  return *kind;
}

int read_id(const JsonValue& value, std::set<int>& earlier) {
  const int id = value.integer();
  if (!earlier.insert(id).second)
    value.refuse("is " + value.shown() + ", which an earlier handle has already");
  return id;
}

StiffDisk read_stiff(const JsonValue& value) {
  value.allow_only({"factor", "radius"});
  const StiffDisk disk{value.at("factor").number(), value.at("radius").number_above_zero()};
  if (!(disk.factor >= kLeastStiffness && disk.factor <= kLargestStiffness))
    value.at("factor").refuse("is " + value.at("factor").shown() +
                              ", but a number from 0.001 to 1000000 is needed");
  return disk;
}

/// Every handle without an id gets the least one from its index on that is not taken.
void name_handles(const Ids& ids, std::set<int> taken, std::vector<Handle>& handles) {
  int free = 0;  // the ids from i to here are taken
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i]) {
      handles[i].id = *ids[i];
      continue;
    }
    free = std::max(free, static_cast<int>(i));
    while (!taken.insert(free).second) ++free;
    handles[i].id = free;
  }
}

}  // namespace

std::vector<Handle> read_handles(const JsonValue& handles, const std::vector<bool>& used_vertices) {
  std::vector<bool> named(used_vertices.size(), false);
  std::vector<Handle> result;
  Ids ids;
  std::set<int> taken;
  for (const JsonValue& item : handles.items()) {
    item.allow_only(
        {"vertex", "target", "id", "kind", "weight", "depth", "angle", "radius", "stiff", "name"});
    Handle handle;
    handle.vertex = read_vertex(item.at("vertex"), used_vertices, named);
    handle.target = item.at("target").point();
    if (const auto kind = item.find("kind")) handle.kind = read_kind(*kind);
    if (const auto weight = item.find("weight")) handle.weight = weight->number_above_zero();
    if (const auto depth = item.find("depth")) handle.depth = depth->number();
    if (item.find("angle") || item.find("radius"))
      handle.turn = Turn{item.at("angle").number(), item.at("radius").number_above_zero()};
    if (const auto stiff = item.find("stiff")) handle.stiff = read_stiff(*stiff);
    if (const auto name = item.find("name")) handle.name = name->text();
    const auto id = item.find("id");
    ids.push_back(id ? std::optional(read_id(*id, taken)) : std::nullopt);
    result.push_back(handle);
  }
  name_handles(ids, std::move(taken), result);
  return result;
}

}  // namespace foldless
