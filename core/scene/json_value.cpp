// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/json_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

std::optional<int> as_integer(const JsonNode& node) {
  const auto* number = node.as<double>();
  if (!number || std::trunc(*number) != *number || std::abs(*number) > 0x7fffffff) return {};
  return static_cast<int>(*number);
}

}  // namespace

void JsonValue::refuse(const std::string& what) const {
  throw Error(*file_ + ':' + std::to_string(node_->line) + ": " +
              (path_.empty() ? "the scene" : path_) + ' ' + what);
}

std::string JsonValue::shown() const {
  if (const auto* string = node_->as<std::string>()) return in_quotes(*string);
  if (const auto* boolean = node_->as<bool>()) return *boolean ? "true" : "false";
  if (const auto* array = node_->as<JsonNode::Array>())
    return "an array of length " + std::to_string(array->size());
  if (node_->as<JsonNode::Object>()) return "an object";
  if (node_->as<std::nullptr_t>()) return "null";
  std::string text;
  append_number(text, *node_->as<double>());
  return text;
}

template <typename T>
const T& JsonValue::expect(std::string_view kind) const {
  const T* value = node_->as<T>();
  if (!value) refuse("is " + shown() + ", but " + std::string(kind) + " is needed");
  return *value;
}

double JsonValue::number() const { return expect<double>("a number"); }
double JsonValue::number_above_zero() const {
  if (!(number() > 0)) refuse("is " + shown() + ", but a number greater than 0 is needed");
  return number();
}
bool JsonValue::boolean() const { return expect<bool>("true or false"); }
const std::string& JsonValue::text() const { return expect<std::string>("a text"); }

const std::string& JsonValue::path() const {
  if (text().empty()) refuse("is '', but the path of a file is needed");
  if (text().find('\0') != std::string::npos)
    refuse("is " + shown() + ", with a character 0, which no name of a file can have");
  return text();
}

int JsonValue::integer() const {
  const auto value = as_integer(*node_);
  if (!value) refuse("is " + shown() + ", but an integer is needed");
  return *value;
}

Vec2 JsonValue::point() const {
  const auto* pair = node_->as<JsonNode::Array>();
  if (!pair || pair->size() != 2) refuse("is " + shown() + ", but a point [x, y] is needed");
  return {item(0).number(), item(1).number()};
}

// The two readers of large arrays make a JsonValue, with its text, only for what is wrong.

Points JsonValue::points() const {
  const auto& array = expect<JsonNode::Array>("an array of points [x, y]");
  Points points(2, static_cast<Eigen::Index>(array.size()));
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto* pair = array[i].as<JsonNode::Array>();
    const bool good =
        pair && pair->size() == 2 && (*pair)[0].as<double>() && (*pair)[1].as<double>();
    points.col(static_cast<Eigen::Index>(i)) =
        good ? Vec2(*(*pair)[0].as<double>(), *(*pair)[1].as<double>()) : item(i).point();
  }
  return points;
}

Triangles JsonValue::triangles() const {
  const auto& array = expect<JsonNode::Array>("an array of triangles [a, b, c]");
  Triangles triangles(3, static_cast<Eigen::Index>(array.size()));
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto* corners = array[i].as<JsonNode::Array>();
    if (!corners || corners->size() != 3)
      item(i).refuse("is " + item(i).shown() + ", but a triangle [a, b, c] is needed");
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = as_integer((*corners)[k]);
      triangles(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
          index ? *index : item(i).item(k).integer();
    }
  }
  return triangles;
}

JsonValue JsonValue::item(std::size_t index) const {
  return {(*node_->as<JsonNode::Array>())[index], *this, '[' + std::to_string(index) + ']'};
}

JsonValue JsonValue::member(const JsonNode& node, std::string_view key) const {
  return {node, *this, std::string(path_.empty() ? "" : ".").append(key)};
}

std::vector<JsonValue> JsonValue::items() const {
  const std::size_t n = expect<JsonNode::Array>("an array").size();
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(item(i));
  return values;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  for (const auto& [name, node] : expect<JsonNode::Object>("an object"))
    if (name == key) return member(node, key);
  return std::nullopt;
}

JsonValue JsonValue::at(std::string_view key) const {
  const auto value = find(key);
  if (!value) refuse("has no key '" + std::string(key) + "', which is needed");
  return *value;
}

void JsonValue::allow_only(const std::vector<std::string_view>& keys) const {
  for (const auto& [name, node] : expect<JsonNode::Object>("an object"))
    if (std::ranges::find(keys, name) == keys.end()) {
      const JsonValue unknown = member(node, in_quotes(name));
      unknown.refuse("= " + unknown.shown() + " is an unknown key; known keys are " + listed(keys));
    }
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

}  // namespace foldless
