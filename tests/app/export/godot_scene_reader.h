// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace foldless::test {

/// A part of a scene file: `[tag attribute=value ...]` and the properties under it.
struct GodotSection {
  std::string tag;
  nlohmann::json attributes, properties;
};

/// Reads text scenes of Godot 4 as its documentation describes them. `Type(a, b)` becomes the list
/// [a, b], a call of one text that text.
class GodotSceneReader {
 public:
  explicit GodotSceneReader(const std::string& text) : text_(text) {
    skip();
    while (at_ < text_.size()) read_section();
  }

  /// The sections of a tag of which an attribute has a value.
  const GodotSection& find(const std::string& tag, const std::string& attribute,
                           const std::string& value) const {
    for (const GodotSection& section : sections)
      if (section.tag == tag && section.attributes.value(attribute, "") == value) return section;
    throw std::runtime_error("no " + tag + " with " + attribute + " " + value);
  }

  std::vector<GodotSection> sections;

 private:
  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c))
      throw std::runtime_error(std::string("no ") + c + " before: " + text_.substr(at_, 40));
  }
  std::string word() {
    skip();
    const std::size_t start = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' ||
            text_[at_] == '/' || text_[at_] == '-' || text_[at_] == '.' || text_[at_] == '+'))
      ++at_;
    if (start == at_) throw std::runtime_error("no word before: " + text_.substr(at_, 40));
    return text_.substr(start, at_ - start);
  }

  void read_section() {
    expect('[');
    GodotSection section;
    section.tag = word();
    while (!take(']')) {
      const std::string key = word();
      expect('=');
      section.attributes[key] = value();
    }
    while (peek() != '[' && peek() != '\0') {
      const std::string key = word();
      expect('=');
      section.properties[key] = value();
    }
    sections.push_back(std::move(section));
  }

  nlohmann::json list(char end) {
    nlohmann::json read = nlohmann::json::array();
    while (!take(end)) {
      if (!read.empty()) expect(',');
      read.push_back(value());
    }
    return read;
  }
  nlohmann::json dictionary() {
    nlohmann::json read = nlohmann::json::object();
    while (!take('}')) {
      if (!read.empty()) expect(',');
      const std::string key = value();
      expect(':');
      read[key] = value();
    }
    return read;
  }
  std::string quoted() {
    std::string read;
    while (text_.at(at_) != '"') {
      if (text_[at_] == '\\') ++at_;
      read += text_.at(at_++);
    }
    ++at_;
    return read;
  }
  nlohmann::json value() {
    if (take('"')) return quoted();
    if (take('[')) return list(']');
    if (take('{')) return dictionary();
    const std::string read = word();
    if (take('(')) {
      const nlohmann::json inside = list(')');
      return inside.size() == 1 && inside[0].is_string() ? inside[0] : inside;
    }
    return nlohmann::json::parse(read);  // A number, true or false.
  }

  const std::string text_;
  std::size_t at_ = 0;
};

}  // namespace foldless::test
