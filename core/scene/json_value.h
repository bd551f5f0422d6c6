// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/scene/json_node.h"

namespace foldless {

/// A value of a JSON file together with its key, such as `handles[3].target`, so that whatever is
/// wrong can be told with file, line, key and value. All readers throw Error.
class JsonValue {
 public:
  /// The root of a file; `node` and `file` must outlive the value.
  JsonValue(const JsonNode& node, const std::string& file) : node_(&node), file_(&file) {}

  /// Throws Error `FILE:LINE: KEY WHAT`; `what` goes on after the key, `is 5, but ...`.
  [[noreturn]] void refuse(const std::string& what) const;
  /// The value in a few words for refuse().
  std::string shown() const;
  const JsonNode& node() const { return *node_; }

  double number() const;  ///< finite
  double number_above_zero() const;
  int integer() const;
  bool boolean() const;
  const std::string& text() const;
  /// A text that can name a file: not empty, no character 0.
  const std::string& path() const;
  /// `[x, y]`
  Vec2 point() const;
  /// `[[x, y], …]` as 2 × #V.
  Points points() const;
  /// `[[a, b, c], …]` as 3 × #F, any integers.
  Triangles triangles() const;

  std::vector<JsonValue> items() const;
  /// The value under a key of this object, or nothing.
  std::optional<JsonValue> find(std::string_view key) const;
  /// The value under a key that must be there.
  JsonValue at(std::string_view key) const;
  /// Refuses this object when it has any other key.
  void allow_only(const std::vector<std::string_view>& keys) const;

 private:
  JsonValue(const JsonNode& node, const JsonValue& parent, const std::string& key)
      : node_(&node), file_(parent.file_), path_(parent.path_ + key) {}
  template <typename T>
  const T& expect(std::string_view kind) const;
  JsonValue item(std::size_t index) const;
  JsonValue member(const JsonNode& node, std::string_view key) const;

  const JsonNode* node_;
  const std::string* file_;
  std::string path_;  ///< empty for the root
};

/// `a, b, c`
std::string listed(const std::vector<std::string_view>& words);

}  // namespace foldless
