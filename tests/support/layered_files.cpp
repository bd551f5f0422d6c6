// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/layered_files.h"

#include <liblzf/lzf.h>
#include <zip.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tests/support/pictures.h"

namespace foldless::test {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

std::string attribute(const std::string& name, double value) {
  return attribute(name, std::to_string(value));
}

std::string attribute(const std::string& name, int value) {
  return attribute(name, std::to_string(value));
}

/// One tile of 64 × 64 pixels: blue, green, red and alpha one after the other, packed.
std::string tile_of(const Image& image, int left, int top) {
  std::string planes(64 * 64 * 4, '\0'), pixels = planes;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c) {
        if (left + x >= image.width || top + y >= image.height) continue;
        const int channel = c < 3 ? 2 - c : 3, p = y * 64 + x;
        const auto byte = static_cast<char>(image.at(left + x, top + y)[channel]);
        planes[static_cast<std::size_t>(c * 64 * 64 + p)] = byte;
        pixels[static_cast<std::size_t>(4 * p + c)] = byte;
      }
  std::string packed(planes.size() - 1, '\0');
  const unsigned size = lzf_compress(planes.data(), static_cast<unsigned>(planes.size()),
                                     packed.data(), static_cast<unsigned>(packed.size()));
  return size == 0 ? std::string(1, '\0') + pixels : std::string(1, '\1') + packed.substr(0, size);
}

std::string pack_bits(const std::string& row) {
  std::string packed;
  for (std::size_t i = 0; i < row.size();) {
    std::size_t run = 1;
    while (i + run < row.size() && run < 128 && row[i + run] == row[i]) ++run;
    if (run > 1) {
      packed += static_cast<char>(1 - static_cast<int>(run));
    } else {
      packed += '\0';
    }
    packed += row[i];
    i += run;
  }
  return packed;
}

std::string zipped(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return packed.substr(0, size);
}

std::string differences_of(std::string row) {
  for (std::size_t i = row.size(); i-- > 1;) row[i] = static_cast<char>(row[i] - row[i - 1]);
  return row;
}

/// The planes of a picture after the word that says how they are packed.
std::string psd_planes(const Image& image, const std::vector<std::size_t>& channels,
                       PsdPacking packing) {
  std::string lengths, rows;
  for (const std::size_t c : channels)
    for (int y = 0; y < image.height; ++y) {
      std::string row;
      for (int x = 0; x < image.width; ++x) row += static_cast<char>(image.at(x, y)[c]);
      if (packing == PsdPacking::bits) row = pack_bits(row);
      if (packing == PsdPacking::differences) row = differences_of(row);
      lengths += big_endian(static_cast<long>(row.size()), 2);
      rows += row;
    }
  const std::string head = big_endian(static_cast<int>(packing), 2);
  if (packing == PsdPacking::bits) return head + lengths + rows;
  return head + (packing == PsdPacking::none ? rows : zipped(rows));
}

std::string part_of(const std::string& bytes) {
  return big_endian(static_cast<long>(bytes.size()), 4) + bytes;
}

std::string psd_name(const std::string& ascii) {
  std::string utf16;
  for (const char c : ascii) utf16 += std::string(1, '\0') + c;
  return "8BIMluni" + part_of(big_endian(static_cast<long>(ascii.size()), 4) + utf16);
}

/// Merged pictures lie on white.
Image on_white(Image image) {
  for (std::size_t p = 0; p < image.pixels.size(); p += 4)
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[p + c] =
          static_cast<std::uint8_t>(255 - (255 - image.pixels[p + c]) * image.pixels[p + 3] / 255);
  return image;
}

}  // namespace

std::string big_endian(long value, int bytes) {
  std::string text;
  for (int b = bytes - 1; b >= 0; --b) text += static_cast<char>((value >> (8 * b)) & 255);
  return text;
}

Image plain(int width, int height, const std::vector<int>& rgba) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(rgba[i % 4]);
  return image;
}

PictureLayer block(const std::string& name, int x, int y, const Image& image) {
  return {name, x, y, image, 1, true};
}

LayeredImage painting_of(int width, int height, std::vector<PictureLayer> layers) {
  LayeredImage painting{width, height, std::move(layers), {}, {}};
  painting.merged = composed(painting);
  return painting;
}

LayeredImage doll() {
  const auto bar = [](double left, double top, double right, double bottom) {
    return alpha_map(160, 200, [=](double x, double y) {
      return 0.5 + std::min({x - left, right - x, y - top, bottom - y});
    });
  };
  const AlphaMap head =
      alpha_map(160, 200, [](double x, double y) { return 30.5 - std::hypot(x - 80, y - 40); });
  const auto layer = [](const std::string& name, const AlphaMap& alpha, std::size_t channel) {
    Image image = painted(alpha);
    for (std::size_t p = channel; p < image.pixels.size(); p += 4) image.pixels[p] = 240;
    return block(name, 0, 0, image);
  };
  std::vector<PictureLayer> layers{layer("Body", bar(50, 70, 110, 190), 0), layer("Head", head, 1),
                                   layer("Left arm", bar(8, 80, 66, 104), 2),
                                   layer("Right arm", bar(94, 80, 152, 104), 1)};
  layers[1].opacity = 0.5;
  return painting_of(160, 200, std::move(layers));
}

std::string zip_of(const Entries& files) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (!archive) throw std::runtime_error(zip_error_strerror(&error));
  for (const auto& [name, bytes] : files)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0),
                 ZIP_FL_OVERWRITE);
  zip_close(archive);
  zip_source_open(target);
  zip_stat_t status;
  zip_source_stat(target, &status);
  std::string bytes(status.size, '\0');
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  zip_error_fini(&error);
  return bytes;
}

std::string ora_layer(const PictureLayer& layer, const std::string& source,
                      const std::string& more) {
  return "<layer" + attribute("name", layer.name) + attribute("src", source) +
         attribute("x", layer.x) + attribute("y", layer.y) + attribute("opacity", layer.opacity) +
         attribute("visibility", layer.is_visible ? "visible" : "hidden") + more + "/>";
}

std::string ora_xml(const LayeredImage& painting, const std::string& layers) {
  return "<?xml version='1.0' encoding='UTF-8'?><image" + attribute("w", painting.width) +
         attribute("h", painting.height) + "><stack>" + layers + "</stack></image>";
}

std::string ora_of(const LayeredImage& painting) {
  Entries files{{"mimetype", "image/openraster"}};
  std::string layers;
  for (const PictureLayer& layer : painting.layers) {
    std::string source = "data/layer";
    source += std::to_string(files.size()) + ".png";
    layers = ora_layer(layer, source) + layers;
    files.emplace_back(source, encode_png(layer.image));
  }
  files.emplace_back("stack.xml", ora_xml(painting, layers));
  files.emplace_back("mergedimage.png", encode_png(painting.merged));
  return zip_of(files);
}

std::string kra_tiles(const PictureLayer& layer) {
  std::string tiles;
  int count = 0;
  for (int y = 0; y < layer.image.height; y += 64)
    for (int x = 0; x < layer.image.width; x += 64, ++count) {
      const std::string tile = tile_of(layer.image, x, y);
      tiles += std::to_string(x) + "," + std::to_string(y) + ",LZF," + std::to_string(tile.size()) +
               "\n" + tile;
    }
  return "VERSION 2\nTILEWIDTH 64\nTILEHEIGHT 64\nPIXELSIZE 4\nDATA " + std::to_string(count) +
         "\n" + tiles;
}

std::string kra_of(const LayeredImage& painting) {
  Entries files{{"mimetype", "application/x-krita"}};
  std::string layers;
  for (const PictureLayer& layer : painting.layers) {
    std::string file = "layer";
    file += std::to_string(files.size());
    layers = "<layer nodetype='paintlayer' colorspacename='RGBA' compositeop='normal'" +
             attribute("name", layer.name) + attribute("filename", file) + attribute("x", layer.x) +
             attribute("y", layer.y) +
             attribute("opacity", static_cast<int>(std::lround(255 * layer.opacity))) +
             attribute("visible", layer.is_visible ? 1 : 0) + "/>" + layers;
    files.emplace_back("Unnamed/layers/" + file, kra_tiles(layer));
    files.emplace_back("Unnamed/layers/" + file + ".defaultpixel", std::string(4, '\0'));
  }
  files.emplace_back("maindoc.xml", "<DOC><IMAGE name='Unnamed'" +
                                        attribute("width", painting.width) +
                                        attribute("height", painting.height) + "><layers>" +
                                        layers + "</layers></IMAGE></DOC>");
  files.emplace_back("mergedimage.png", encode_png(painting.merged));
  return zip_of(files);
}

std::string psd_of(const LayeredImage& painting, const std::vector<PsdLayer>& layers,
                   PsdPacking packing) {
  // The first channel that is no colour is the merged picture's alpha: a negative count.
  std::string records = big_endian(-static_cast<long>(layers.size()), 2), pixels;
  for (const PsdLayer& psd : layers) {
    const PictureLayer& layer = psd.layer;
    const Image& image = layer.image;
    for (const int edge : {layer.y, layer.x, layer.y + image.height, layer.x + image.width})
      records += big_endian(edge, 4);
    records += big_endian(4, 2);
    for (const int channel : {-1, 0, 1, 2}) {
      const std::string plane =
          psd_planes(image, {channel < 0 ? 3 : static_cast<std::size_t>(channel)}, packing);
      records += big_endian(channel, 2) + big_endian(static_cast<long>(plane.size()), 4);
      pixels += plane;
    }
    records += "8BIM" + psd.blend + big_endian(std::lround(255 * layer.opacity), 1) +
               big_endian(0, 1) + big_endian(layer.is_visible ? 0 : 2, 1) + big_endian(0, 1);
    std::string more = part_of(psd.mask) + part_of("") + std::string("\3old", 4);
    if (psd.divider >= 0) more += "8BIMlsct" + part_of(big_endian(psd.divider, 4));
    records += part_of(more + psd_name(layer.name));
  }
  return "8BPS" + big_endian(1, 2) + std::string(6, '\0') + big_endian(4, 2) +
         big_endian(painting.height, 4) + big_endian(painting.width, 4) + big_endian(8, 2) +
         big_endian(3, 2) + part_of("") + part_of("") +
         part_of(part_of(records + pixels) + part_of("")) +
         psd_planes(on_white(painting.merged), {0, 1, 2, 3}, packing);
}

std::string psd_of(const LayeredImage& painting, PsdPacking packing) {
  std::vector<PsdLayer> layers;
  for (const PictureLayer& layer : painting.layers) layers.push_back({layer});
  return psd_of(painting, layers, packing);
}

}  // namespace foldless::test
