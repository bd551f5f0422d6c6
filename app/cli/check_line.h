// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/scene/json_node.h"

namespace foldless {

/// The line of JSON that `check` prints: what was found, what is wrong, and whether all is well.
class CheckLine {
 public:
  void add(std::string_view key, double value) { object_.emplace_back(key, node_of(value)); }
  void add(std::string_view key, bool value) { object_.emplace_back(key, JsonNode{value}); }
  /// Something that is wrong.
  void add_problem(std::string words) { problems_.push_back({std::move(words)}); }

  std::string text() &&;

 private:
  JsonNode::Object object_;
  JsonNode::Array problems_;
};

}  // namespace foldless
