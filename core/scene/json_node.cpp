// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/json_node.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "core/error.h"
#include "core/files/text_lines.h"

namespace foldless {
namespace {

constexpr std::size_t kMaxDepth = 100;
constexpr std::size_t kMaxKeys = 10000;       // of one object
constexpr std::size_t kMaxValues = 30000000;  // of a file: a mesh of two million triangles has less

/// Lines seen by the library's parser, which tells its handler no positions. It reads one
/// character beyond a number, and that may be the end of the line: only what is not blank counts.
struct LineCounter {
  int current = 1;
  int of_last_token = 1;

  void see(char c) {
    if (c == '\n') ++current;
    if (c != ' ' && c != '\t' && c != '\n' && c != '\r') of_last_token = current;
  }
};

/// Characters of a text; each is seen by a counter when it is read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  CountingIterator(const char* position, LineCounter* counter)
      : position_(position), counter_(counter) {}

  char operator*() const {
    counter_->see(*position_);
    return *position_;
  }
  CountingIterator& operator++() {
    ++position_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++position_;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return position_ == other.position_; }

 private:
  const char* position_;
  LineCounter* counter_;
};

/// Receives the events of the library's parser.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(const std::string& name, const LineCounter& lines) : name_(name), lines_(lines) {}

  JsonNode root;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) override { return add(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonNode::Object{}); }
  bool start_array(std::size_t) override { return open(JsonNode::Array{}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& key) override {
    auto& object = std::get<JsonNode::Object>(open_.back().node->value);
    if (object.size() == kMaxKeys)
      refuse("an object has more than " + std::to_string(kMaxKeys) + " keys");
    if (!open_.back().keys.insert(key).second)
      refuse("the key " + in_quotes(key) + " comes twice, first in line " +
             std::to_string(std::ranges::find(object, key, &JsonNode::Member::key)->value.line));
    object.emplace_back(key, JsonNode{});
    return true;
  }

  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception& error) override {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: what is wrong"
    std::string_view what = error.what();
    if (const auto id = what.find("] "); id != what.npos) what.remove_prefix(id + 2);
    if (const auto colon = what.find(": "); what.starts_with("parse error") && colon != what.npos)
      what.remove_prefix(colon + 2);
    std::string words(what);
    if (const std::string place = path(); !place.empty()) words.append(", in ").append(place);
    std::ranges::replace_if(
        words, [](char c) { return c < ' ' || c > '~'; }, '?');
    refuse("not JSON: " + words);
  }

 private:
  /// An array or object that is not closed yet. The node stays where it is until then.
  struct Open {
    JsonNode* node;
    std::unordered_set<std::string> keys;  ///< of an object
  };

  /// What is being read, such as `handles[3].target[0]`.
  std::string path() const {
    std::string path;
    for (const Open& open : open_) {
      const bool is_innermost = &open == &open_.back();  // its next value is not in it yet
      if (const auto* array = open.node->as<JsonNode::Array>())
        path += '[' + std::to_string(array->size() - (is_innermost ? 0 : 1)) + ']';
      if (const auto* object = open.node->as<JsonNode::Object>(); object && !object->empty())
        path += (path.empty() ? "" : ".") + object->back().key;
    }
    return path;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(name_ + ':' + std::to_string(lines_.of_last_token) + ": " + what);
  }

  template <typename Value>
  JsonNode& place(Value value) {
    if (++count_ > kMaxValues)
      refuse("there are more than " + std::to_string(kMaxValues) + " values");
    JsonNode* node = &root;
    if (!open_.empty()) {
      auto& parent = open_.back().node->value;
      if (auto* array = std::get_if<JsonNode::Array>(&parent)) node = &array->emplace_back();
      if (auto* object = std::get_if<JsonNode::Object>(&parent)) node = &object->back().value;
    }
    node->value = std::move(value);
    node->line = lines_.of_last_token;
    return *node;
  }

  template <typename Value>
  bool add(Value value) {
    place(std::move(value));
    return true;
  }

  template <typename Value>
  bool open(Value value) {
    if (open_.size() == kMaxDepth)
      refuse("values are nested more than " + std::to_string(kMaxDepth) + " levels deep");
    open_.push_back({&place(std::move(value)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& name_;
  const LineCounter& lines_;
  std::size_t count_ = 0;  ///< of values so far
  std::vector<Open> open_;
};

}  // namespace

JsonNode node_of(double value) {
  if (!std::isfinite(value)) return {nullptr};
  return {value};
}

JsonNode node_of(std::string_view text) { return {std::string(text)}; }

JsonNode parse_json(std::string_view text, const std::string& name) {
  LineCounter lines;
  Builder builder(name, lines);
  const CountingIterator begin(text.data(), &lines);
  const CountingIterator end(text.data() + text.size(), &lines);
  nlohmann::json::sax_parse(begin, end, &builder);
  return std::move(builder.root);
}

nlohmann::json to_library(const JsonNode& node) {
  if (const auto* boolean = node.as<bool>()) return *boolean;
  if (const auto* number = node.as<double>()) return *number;
  if (const auto* text = node.as<std::string>()) return *text;
  if (const auto* array = node.as<JsonNode::Array>()) {
    nlohmann::json json = nlohmann::json::array();
    for (const JsonNode& item : *array) json.push_back(to_library(item));
    return json;
  }
  if (const auto* object = node.as<JsonNode::Object>()) {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [key, item] : *object) json[key] = to_library(item);
    return json;
  }
  return nullptr;
}

JsonNode from_library(const nlohmann::json& json) {
  if (json.is_boolean()) return {json.get<bool>()};
  if (json.is_number()) return {json.get<double>()};
  if (json.is_string()) return {json.get<std::string>()};
  if (json.is_array()) {
    JsonNode::Array array;
    for (const nlohmann::json& item : json) array.push_back(from_library(item));
    return {std::move(array)};
  }
  if (json.is_object()) {
    JsonNode::Object object;
    for (const auto& [key, item] : json.items()) object.emplace_back(key, from_library(item));
    return {std::move(object)};
  }
  return {nullptr};
}

}  // namespace foldless
