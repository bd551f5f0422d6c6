// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/text_lines.h"
#include "core/scene/json_node.h"

namespace foldless {
namespace {

/// Levels of nesting, 0 for a number; counted up to `limit` only.
int depth(const JsonNode& node, int limit) {
  if (limit == 0) return 0;
  int deepest = -1;
  if (const auto* array = node.as<JsonNode::Array>()) {
    deepest = 0;
    for (const JsonNode& item : *array) deepest = std::max(deepest, depth(item, limit - 1));
  }
  if (const auto* object = node.as<JsonNode::Object>()) {
    deepest = 0;
    for (const auto& [key, item] : *object) deepest = std::max(deepest, depth(item, limit - 1));
  }
  return deepest + 1;
}

/// A point stands on one line, and so does an object of numbers and points.
bool fits_a_line(const JsonNode& node) {
  return node.as<JsonNode::Array>() ? depth(node, 2) < 2 : depth(node, 3) < 3;
}

/// Up to where all whole numbers are doubles.
bool is_integer(double number) {
  constexpr double kLargest = 9007199254740992;  // 2⁵³
  return std::abs(number) <= kLargest && number == std::trunc(number);
}

class Writer {
 public:
  std::string text;

  void write(const JsonNode& node, bool on_one_line) {
    if (const auto* boolean = node.as<bool>()) text += *boolean ? "true" : "false";
    if (const auto* number = node.as<double>()) write_number(*number);
    if (const auto* string = node.as<std::string>()) write_string(*string);
    if (node.as<std::nullptr_t>()) text += "null";
    if (const auto* array = node.as<JsonNode::Array>())
      write_items(*array, "[]", on_one_line, [](const JsonNode&) {});
    if (const auto* object = node.as<JsonNode::Object>())
      write_items(*object, "{}", on_one_line, [this](const JsonNode::Member& item) {
        write_string(item.key);
        text += ": ";
      });
  }

 private:
  static const JsonNode& value_of(const JsonNode& item) { return item; }
  static const JsonNode& value_of(const JsonNode::Member& item) { return item.value; }

  template <typename Items, typename WriteKey>
  void write_items(const Items& items, std::string_view brackets, bool on_one_line,
                   const WriteKey& write_key) {
    const bool is_flat = on_one_line || items.empty();
    text += brackets[0];
    ++level_;
    bool first = true;
    for (const auto& item : items) {
      if (!first) text += is_flat ? ", " : ",";
      first = false;
      if (!is_flat) new_line();
      write_key(item);
      write(value_of(item), is_flat || fits_a_line(value_of(item)));
    }
    --level_;
    if (!is_flat) new_line();
    text += brackets[1];
  }

  void new_line() { text.append("\n").append(2 * level_, ' '); }

  void write_number(double number) {
    if (!std::isfinite(number)) throw Error("a number is not finite and cannot be saved");
    if (number == 0 && std::signbit(number))
      text += "-0.0";  // -0 would be read as an integer
    else if (is_integer(number))
      text += std::to_string(static_cast<long long>(number));  // 2e+05 is no index to many readers
    else
      append_number(text, number);
  }

  void write_string(const std::string& string) {
    text += nlohmann::json(string).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }

  std::size_t level_ = 0;
};

}  // namespace

std::string json_text(const JsonNode& node) {
  Writer writer;
  writer.write(node, false);
  return std::move(writer.text) + '\n';
}

std::string json_line(const JsonNode& node) {
  // Line breaks inside strings are escaped: those that are left, with the blanks that follow,
  // are layout.
  std::string line;
  bool is_layout = false;
  for (const char c : json_text(node)) {
    is_layout = c == '\n' || (is_layout && c == ' ');
    if (!is_layout) line += c;
  }
  return line;
}

}  // namespace foldless
