// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/layered/layer_xml.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace foldless {
namespace {

constexpr double kFarthestPlace = 1e8;  // pixels; sums are far from overflows

/// Whatever the locale is.
template <typename Number>
Number number_of(const pugi::xml_node& node, const char* attribute, Number otherwise) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found) return otherwise;
  const std::string_view text = found.value();
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    std::string wrong = "the attribute ";
    wrong += attribute;
    wrong += " of an element '";
    wrong += node.name();
    wrong += "' is not a number: '";
    wrong += text.substr(0, 40);
    throw Error(wrong + "'");
  }
  return number;
}

}  // namespace

pugi::xml_document read_xml(const ZipArchive& archive, const std::string& name) {
  const std::string text = archive.read(name, kMostXmlBytes);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) throw Error(name + " in the archive is damaged (" + result.description() + ")");
  return document;
}

int integer_at(const pugi::xml_node& node, const char* attribute, int otherwise) {
  return number_of(node, attribute, otherwise);
}

double number_at(const pugi::xml_node& node, const char* attribute, double otherwise) {
  const double number = number_of(node, attribute, otherwise);
  if (!std::isfinite(number))
    throw Error(std::string("the attribute ") + attribute + " of a layer is not finite");
  return number;
}

LayerGroup group_within(const LayerGroup& outer, LayerGroup inner) {
  inner.depth = outer.depth + 1;
  if (inner.depth > kDeepestGroup)
    throw Error("groups of layers are nested more than " + std::to_string(kDeepestGroup) + " deep");
  for (const int place : {inner.x, inner.y, outer.x, outer.y})
    if (std::abs(static_cast<double>(place)) > kFarthestPlace)
      throw Error("a layer or a group of layers lies too far from the canvas");
  inner.x += outer.x;
  inner.y += outer.y;
  inner.opacity *= outer.opacity;
  inner.is_visible = inner.is_visible && outer.is_visible;
  return inner;
}

}  // namespace foldless
