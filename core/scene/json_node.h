// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foldless {

/// A JSON value that knows its line and keeps the order of keys. Numbers are doubles.
struct JsonNode {
  struct Member;
  using Array = std::vector<JsonNode>;
  using Object = std::vector<Member>;

  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value;
  int line = 0;  ///< where the value begins, from 1; 0: not from a file

  /// The value as a T, or null when it is of another kind.
  template <typename T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
};

/// A key of an object with its value. No std::pair: that cannot be declared before a JsonNode is
/// complete, and an object is a part of one.
struct JsonNode::Member {
  Member(std::string_view key_text, JsonNode node) : key(key_text), value(std::move(node)) {}

  std::string key;
  JsonNode value;
};

/// A number; null where it is not finite, for which JSON has no word.
JsonNode node_of(double value);
JsonNode node_of(std::string_view text);

/// Parses a JSON text. Throws Error `NAME:LINE: ...` when it is not JSON, when an object has a key
/// twice, when a number is too large, and for more than a hundred nested levels, ten thousand keys
/// of an object or thirty million values.
JsonNode parse_json(std::string_view text, const std::string& name);

/// The text of a value, ended by a newline: points, triangles and handles on a line each. Every
/// number is the shortest that reads back exactly. Throws Error for a number that is not finite.
std::string json_text(const JsonNode& node);

/// The same on one line, without an end.
std::string json_line(const JsonNode& node);

/// To and from the type of the JSON library, for values that are passed on as they are.
nlohmann::json to_library(const JsonNode& node);
JsonNode from_library(const nlohmann::json& json);

}  // namespace foldless
