// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "render/layered/layer_collector.h"
#include "render/layered/layer_formats.h"
#include "render/layered/layer_xml.h"
#include "render/layered/merged_image.h"

namespace foldless {
namespace {

/// How an element, a layer or a stack of them, is painted.
LayerGroup look_of(const pugi::xml_node& node) {
  return {0, integer_at(node, "x", 0), integer_at(node, "y", 0),
          std::clamp(number_at(node, "opacity", 1), 0.0, 1.0),
          std::string_view(node.attribute("visibility").as_string("visible")) != "hidden"};
}

/// Walks through stack.xml from the top layer down.
class StackReader {
 public:
  StackReader(const ZipArchive& archive, LayerCollector& layers)
      : archive_(archive), layers_(layers) {}

  void read_stack(const pugi::xml_node& stack, const LayerGroup& group) {
    for (const pugi::xml_node& node : stack.children()) {
      if (layers_.has_given_up()) return;
      const std::string_view kind = node.name();
      if (kind == "stack") {
        const LayerGroup look = group_within(group, look_of(node));
        if (look.is_visible) note_group(node);
        read_stack(node, look);
      } else if (kind == "layer") {
        read_layer(node, group_within(group, look_of(node)));
      }
    }
  }

 private:
  void read_layer(const pugi::xml_node& node, const LayerGroup& look) {
    PictureLayer layer{
        node.attribute("name").as_string(), look.x, look.y, {}, look.opacity, look.is_visible};
    if (layer.is_visible) {
      if (!is_normal(node)) layers_.note(std::string(kBlendNote), layer.name);
      const std::string source = node.attribute("src").as_string();
      try {
        layer.image = decode_image(archive_.read(source, kMostPixelBytes));
      } catch (const Error& error) {
        throw Error("the layer '" + layer.name + "': " + error.what());
      }
    }
    layers_.add(std::move(layer));
  }

  void note_group(const pugi::xml_node& node) {
    const std::string name = node.attribute("name").as_string();
    if (!is_normal(node)) layers_.note(std::string(kBlendNote), name);
    if (look_of(node).opacity < 1) layers_.note(std::string(kGroupNote), name);
  }

  static bool is_normal(const pugi::xml_node& node) {
    return std::string_view(node.attribute("composite-op").as_string("svg:src-over")) ==
           "svg:src-over";
  }

  const ZipArchive& archive_;
  LayerCollector& layers_;
};

}  // namespace

LayeredImage decode_open_raster(const ZipArchive& archive, LayeredParts parts) {
  const pugi::xml_document document = read_xml(archive, "stack.xml");
  const pugi::xml_node image = document.child("image");
  if (!image) throw Error("stack.xml in the archive has no image");
  LayerCollector layers(integer_at(image, "w", 0), integer_at(image, "h", 0));
  return with_merged(archive, parts, layers,
                     [&] { StackReader(archive, layers).read_stack(image.child("stack"), {}); });
}

}  // namespace foldless
