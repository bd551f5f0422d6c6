// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/rig_json.h"
#include "core/scene/json_object.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace foldless {
namespace {

JsonNode point_of_axis(const Vec2& p) { return {array_of(JsonNode{p.x()}, JsonNode{p.y()})}; }

}  // namespace

std::vector<Bones> read_bones(const JsonValue& bones, const std::vector<Handle>& handles) {
  std::vector<Bones> result;
  std::set<int> named;
  for (const JsonValue& item : bones.items()) {
    Bones& chain = result.emplace_back();
    for (const JsonValue& joint : item.items()) {
      const int id = joint.integer();
      if (std::ranges::find(handles, id, &Handle::id) == handles.end())
        joint.refuse("is " + joint.shown() + ", but no handle has that id");
      if (!named.insert(id).second)
        joint.refuse("is " + joint.shown() + ", a handle that is a joint already");
      chain.push_back(id);
    }
    if (chain.size() < 2)
      item.refuse("is " + item.shown() + ", but the ids of two handles or more are needed");
  }
  return result;
}

JsonNode bones_node(const std::vector<Bones>& bones) {
  JsonNode::Array chains;
  for (const Bones& chain : bones) {
    JsonNode::Array joints;
    for (const int id : chain) joints.push_back({static_cast<double>(id)});
    chains.push_back({std::move(joints)});
  }
  return {std::move(chains)};
}

Mirror read_mirror(const JsonValue& mirror) {
  mirror.allow_only({"from", "to", "on"});
  Mirror result;
  result.axis = {mirror.at("from").point(), mirror.at("to").point()};
  if (const auto on = mirror.find("on")) result.is_on = on->boolean();
  const double length = (result.axis.to - result.axis.from).norm();
  if (!(length > 0 && std::isfinite(length)))
    mirror.at("to").refuse("is no other point than 'from', but an axis needs two");
  return result;
}

JsonNode mirror_node(const Mirror& mirror) {
  JsonNode::Object object = object_of(JsonMember("from", point_of_axis(mirror.axis.from)),
                                      JsonMember("to", point_of_axis(mirror.axis.to)));
  if (!mirror.is_on) object.emplace_back("on", JsonNode{false});
  return {std::move(object)};
}

}  // namespace foldless
