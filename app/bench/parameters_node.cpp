// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/parameters_node.h"

#include <utility>

#include "core/method/methods.h"
#include "core/scene/parameter_keys.h"

namespace foldless {

JsonNode parameters_node(const Parameters& parameters, const Density& energy) {
  JsonNode::Object object;
  for (const ParameterKey& key : parameter_keys()) {
    // Only β may be absent: it then is the energy's own.
    const double value = key.get(parameters).value_or(default_beta(parameters.method, energy));
    if (key.kind == ParameterKind::word)
      object.emplace_back(key.name, node_of(key.words[static_cast<std::size_t>(value)]));
    else if (key.kind == ParameterKind::flag)
      object.emplace_back(key.name, JsonNode{value != 0});
    else
      object.emplace_back(key.name, node_of(value));
  }
  return {std::move(object)};
}

}  // namespace foldless
