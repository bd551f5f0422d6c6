// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "render/layered/krita_tiles.h"
#include "render/layered/layer_collector.h"
#include "render/layered/layer_formats.h"
#include "render/layered/layer_xml.h"
#include "render/layered/merged_image.h"

namespace foldless {
namespace {

constexpr std::string_view kColours = "RGBA";  // 8 bits each

LayerGroup look_of_node(const pugi::xml_node& node) {
  return {0, integer_at(node, "x", 0), integer_at(node, "y", 0),
          std::clamp(integer_at(node, "opacity", 255), 0, 255) / 255.0,
          integer_at(node, "visible", 1) != 0};
}

bool is_of_normal_mode(const pugi::xml_node& node) {
  return std::string_view(node.attribute("compositeop").as_string("normal")) == "normal";
}

/// Walks through maindoc.xml from the top layer down.
class KritaReader {
 public:
  KritaReader(const ZipArchive& archive, std::string folder, LayerCollector& layers)
      : archive_(archive), folder_(std::move(folder)), layers_(layers) {}

  void read_layers(const pugi::xml_node& nodes, const LayerGroup& group) {
    for (const pugi::xml_node& node : nodes.children("layer")) {
      if (layers_.has_given_up()) return;
      const std::string name = node.attribute("name").as_string();
      const LayerGroup look = group_within(group, look_of_node(node));
      const std::string_view kind = node.attribute("nodetype").as_string();
      const bool is_read = kind == "grouplayer" || kind == "paintlayer";
      if (is_read && look.is_visible) note_look(node, name);
      if (kind == "grouplayer") {
        if (look.is_visible && look_of_node(node).opacity < 1)
          layers_.note(std::string(kGroupNote), name);
        read_layers(node.child("layers"), look);
      } else if (kind == "paintlayer") {
        read_paint_layer(node, name, look);
      } else if (look.is_visible) {
        layers_.note("left out, as they are no paint layers", name);
      }
    }
  }

 private:
  void note_look(const pugi::xml_node& node, const std::string& name) {
    if (!is_of_normal_mode(node)) layers_.note(std::string(kBlendNote), name);
    if (node.child("masks").first_child()) layers_.note(std::string(kMaskNote), name);
  }

  void read_paint_layer(const pugi::xml_node& node, const std::string& name,
                        const LayerGroup& look) {
    PictureLayer layer{name, look.x, look.y, {}, look.opacity, look.is_visible};
    if (node.attribute("colorspacename").as_string() != kColours)
      return layers_.give_up(
          "Layers that are not of 8-bit RGB colours are only read merged: the layer '" + name +
          "'");
    if (look.is_visible) {
      const std::string file = folder_ + node.attribute("filename").as_string();
      try {
        layer = read_tiles(file, std::move(layer));
      } catch (const Error& error) {
        throw Error("the layer '" + name + "': " + error.what());
      }
    }
    layers_.add(std::move(layer));
  }

  PictureLayer read_tiles(const std::string& file, PictureLayer layer) const {
    const std::string default_file = file + ".defaultpixel";
    std::string default_pixel(4, '\0');
    if (archive_.has(default_file)) default_pixel = archive_.read(default_file, kMostXmlBytes);
    const std::string tiles = archive_.read(file, kMostPixelBytes);
    return with_tiles(tiles, default_pixel, std::move(layer), {layers_.width(), layers_.height()});
  }

  const ZipArchive& archive_;
  std::string folder_;
  LayerCollector& layers_;
};

}  // namespace

LayeredImage decode_krita(const ZipArchive& archive, LayeredParts parts) {
  const pugi::xml_document document = read_xml(archive, "maindoc.xml");
  const pugi::xml_node image = document.child("DOC").child("IMAGE");
  if (!image) throw Error("maindoc.xml in the archive has no image");
  LayerCollector layers(integer_at(image, "width", 0), integer_at(image, "height", 0));
  return with_merged(archive, parts, layers, [&] {
    const std::string folder = std::string(image.attribute("name").as_string()) + "/layers/";
    KritaReader(archive, folder, layers).read_layers(image.child("layers"), {});
  });
}

}  // namespace foldless
