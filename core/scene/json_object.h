// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <utility>

#include "core/scene/json_node.h"

namespace foldless {

using JsonMember = JsonNode::Member;

/// An object of these members. Not by braces: where memory is short while they are filled, what
/// GCC 12 makes of them destroys what is not there.
template <std::same_as<JsonMember>... Members>
JsonNode::Object object_of(Members... members) {
  JsonNode::Object object;
  object.reserve(sizeof...(members));
  (object.push_back(std::move(members)), ...);
  return object;
}

/// The same of a list.
template <std::same_as<JsonNode>... Nodes>
JsonNode::Array array_of(Nodes... nodes) {
  JsonNode::Array array;
  array.reserve(sizeof...(nodes));
  (array.push_back(std::move(nodes)), ...);
  return array;
}

}  // namespace foldless
