// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/layered/layered_image.h"

namespace foldless::test {

/// A one-coloured layer.
PictureLayer block(const std::string& name, int x, int y, const Image& image);
/// A picture of one colour.
Image plain(int width, int height, const std::vector<int>& rgba);
/// A painting whose merged picture is made of its layers.
LayeredImage painting_of(int width, int height, std::vector<PictureLayer> layers);

/// A figure of four soft-edged layers, 160 × 200 pixels: Body, Head, Left arm and Right arm, which
/// lie over the body's sides. The head is half transparent.
LayeredImage doll();

/// A zip archive of files, name and bytes.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files);

// A painting as the bytes of a file, as the programs write it.
std::string ora_of(const LayeredImage& painting);
std::string kra_of(const LayeredImage& painting);
/// How pixels are packed: as they are, PackBits, zipped, or differences zipped.
enum class PsdPacking { none, bits, zip, differences };
std::string psd_of(const LayeredImage& painting, PsdPacking packing = PsdPacking::bits);

// Pieces of such files.
std::string ora_layer(const PictureLayer& layer, const std::string& source,
                      const std::string& more = "");
std::string ora_xml(const LayeredImage& painting, const std::string& layers);
std::string kra_tiles(const PictureLayer& layer);
/// The record of a layer and then the channels of all: `more` goes into the record's blocks.
struct PsdLayer {
  PictureLayer layer;
  std::string blend = "norm";
  int divider = -1;  ///< 1: a group, 3: the end of one
  std::string mask = {};
};
std::string psd_of(const LayeredImage& painting, const std::vector<PsdLayer>& layers,
                   PsdPacking packing);
/// High byte first.
std::string big_endian(long value, int bytes);

}  // namespace foldless::test
