// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "render/layered/layer_collector.h"
#include "render/layered/layer_formats.h"
#include "render/layered/layer_xml.h"
#include "render/layered/merged_image.h"
#include "render/layered/photoshop_bytes.h"

namespace foldless {
namespace {

constexpr int kGrey = 1, kRgb = 3, kCmyk = 4;  // colour modes
constexpr int kAlphaChannel = -1;
constexpr std::size_t kBlockHead = 12;  // signature, key and length

/// The head of a file.
struct PhotoshopHead {
  unsigned channels, depth;
  int mode;
  long width, height;

  bool is_8_bit_rgb() const { return mode == kRgb && depth == 8; }
};

PhotoshopHead read_photoshop_head(PhotoshopBytes& bytes) {
  bytes.take(4);  // the signature
  if (bytes.word() != 1)
    throw Error("is a large document (.psb) of Photoshop; save it as .psd, .png or .ora");
  bytes.take(6);
  PhotoshopHead head{};
  head.channels = bytes.word();
  head.height = bytes.long_word();
  head.width = bytes.long_word();
  head.depth = bytes.word();
  head.mode = static_cast<int>(bytes.word());
  if (head.channels < 1 || head.channels > 56) throw Error("the head of the file is damaged");
  return head;
}

/// What a file says of a layer, in the order of its pixels: the lowest first.
struct LayerRecord {
  enum class Kind { layer, group, group_end };

  int top = 0, left = 0;
  long height = 0, width = 0;
  std::vector<std::pair<int, std::size_t>> channels;  ///< what it is, and its bytes
  std::string name;
  Kind kind = Kind::layer;
  double opacity = 1;
  bool is_visible = true, is_normal = true, has_mask = false, is_clipped = false,
       has_effects = false;
  std::string_view pixels;  ///< of all channels
};

/// The blocks of more that is known of a layer.
void read_blocks(PhotoshopBytes blocks, LayerRecord& record) {
  while (blocks.left() >= kBlockHead) {
    const std::string_view signature = blocks.take(4);
    if (signature != "8BIM" && signature != "8B64") return;  // what fills up the end
    const std::string_view key = blocks.take(4);
    PhotoshopBytes block = blocks.part();
    if (key == "luni") record.name = block.long_name();
    if (key == "lfx2" || key == "lrFX") record.has_effects = true;
    if (key != "lsct" && key != "lsdk") continue;
    const std::uint32_t divider = block.long_word();
    if (divider == 1 || divider == 2) record.kind = LayerRecord::Kind::group;
    if (divider == 3) record.kind = LayerRecord::Kind::group_end;
  }
}

LayerRecord read_record(PhotoshopBytes& bytes) {
  LayerRecord record;
  record.top = bytes.signed_long_word();
  record.left = bytes.signed_long_word();
  record.height = static_cast<long>(bytes.signed_long_word()) - record.top;
  record.width = static_cast<long>(bytes.signed_long_word()) - record.left;
  for (unsigned left = bytes.word(); left > 0; --left) {
    const int id = bytes.signed_word();
    record.channels.emplace_back(id, bytes.long_word());
  }
  bytes.take(4);  // a signature
  const std::string_view blend = bytes.take(4);
  record.is_normal = blend == "norm" || blend == "pass";
  record.opacity = bytes.byte() / 255.0;
  record.is_clipped = bytes.byte() != 0;
  record.is_visible = (bytes.byte() & 2) == 0;
  bytes.take(1);
  PhotoshopBytes more = bytes.part();
  record.has_mask = !more.part().is_at_end();
  more.part();  // what is blended with what
  record.name = more.short_name();
  read_blocks(more, record);
  return record;
}

std::vector<LayerRecord> read_records(PhotoshopBytes section) {
  std::vector<LayerRecord> records;
  if (section.is_at_end()) return records;
  PhotoshopBytes info = section.part();
  if (info.is_at_end()) return records;
  for (int left = std::abs(info.signed_word()); left > 0; --left)
    records.push_back(read_record(info));
  for (LayerRecord& record : records) {
    std::size_t bytes = 0;
    for (const auto& channel : record.channels) bytes += channel.second;
    record.pixels = info.take(bytes);
  }
  return records;
}

Image image_of(const LayerRecord& record) {
  if (record.width == 0 || record.height == 0) return {};
  check_image_size(record.width, record.height);
  Image image(static_cast<int>(record.width), static_cast<int>(record.height));
  for (std::size_t p = 3; p < image.pixels.size(); p += 4) image.pixels[p] = 255;
  PhotoshopBytes bytes(record.pixels);
  for (const auto& [id, count] : record.channels) {
    PhotoshopBytes channel(bytes.take(count));
    if (id < kAlphaChannel || id > 2) continue;
    const auto rows = static_cast<std::size_t>(image.height);
    const std::string plane =
        unpacked_rows(channel, {static_cast<std::size_t>(image.width), rows, rows});
    const std::size_t place = id == kAlphaChannel ? 3 : static_cast<std::size_t>(id);
    for (std::size_t p = 0; p < plane.size(); ++p)
      image.pixels[4 * p + place] = static_cast<std::uint8_t>(plane[p]);
  }
  return image;
}

void note_what_is_lost(const LayerRecord& record, LayerCollector& layers) {
  if (!record.is_normal) layers.note(std::string(kBlendNote), record.name);
  if (record.has_mask) layers.note(std::string(kMaskNote), record.name);
  if (record.is_clipped) layers.note("not clipped to what is below", record.name);
  if (record.has_effects) layers.note("shown without their effects", record.name);
}

/// A group comes after, that is over, what it holds, and its end before.
void add_layers(const std::vector<LayerRecord>& records, LayerCollector& layers) {
  std::vector<LayerGroup> groups{{}};
  for (auto it = records.rbegin(); it != records.rend(); ++it) {
    const LayerRecord& record = *it;
    if (record.kind == LayerRecord::Kind::group_end) {
      if (groups.size() > 1) groups.pop_back();
      continue;
    }
    const LayerGroup look =
        group_within(groups.back(), {0, 0, 0, record.opacity, record.is_visible});
    if (look.is_visible) note_what_is_lost(record, layers);
    if (record.kind == LayerRecord::Kind::group) {
      if (look.is_visible && record.opacity < 1) layers.note(std::string(kGroupNote), record.name);
      groups.push_back(look);
      continue;
    }
    if (layers.has_given_up()) return;
    layers.add({record.name, record.left, record.top, look.is_visible ? image_of(record) : Image{},
                look.opacity, look.is_visible});
  }
}

/// The merged picture lies on white, which is taken away where it is not opaque.
std::uint8_t without_white(int value, int alpha) {
  if (alpha == 0) return 0;
  return static_cast<std::uint8_t>(std::clamp(255 - (255 - value) * 255 / alpha, 0, 255));
}

Image read_merged(PhotoshopBytes& bytes, const PhotoshopHead& head, bool has_alpha) {
  const std::size_t colours = head.mode == kGrey ? 1 : head.mode == kRgb ? 3 : 4;
  if ((head.mode != kGrey && head.mode != kRgb && head.mode != kCmyk) || head.channels < colours ||
      (head.depth != 8 && head.depth != 16))
    throw Error("the Photoshop file is not of 8 or 16 bits of RGB, CMYK or grey; convert it");
  const std::size_t size = head.depth / 8;
  const auto width = static_cast<std::size_t>(head.width);
  const auto height = static_cast<std::size_t>(head.height);
  const std::size_t used = colours + (has_alpha && head.channels > colours ? 1 : 0);
  const std::string planes =
      unpacked_rows(bytes, {width * size, used * height, head.channels * height});
  Image image(static_cast<int>(head.width), static_cast<int>(head.height));
  const auto at = [&](std::size_t channel, std::size_t p) {
    return static_cast<int>(
        static_cast<unsigned char>(planes[(channel * width * height + p) * size]));
  };
  for (std::size_t p = 0; p < width * height; ++p) {
    std::uint8_t* pixel = &image.pixels[4 * p];
    const int alpha = used > colours ? at(colours, p) : 255;
    for (std::size_t c = 0; c < 3; ++c) {
      const int value = at(head.mode == kGrey ? 0 : c, p);
      const int light = head.mode == kCmyk ? (value * at(3, p) + 127) / 255 : value;
      pixel[c] = without_white(light, alpha);
    }
    pixel[3] = static_cast<std::uint8_t>(alpha);
  }
  return image;
}

/// Photoshop may leave out the merged picture and says so among the resources.
bool has_merged_picture(PhotoshopBytes resources) {
  constexpr unsigned kVersionInfo = 1057;
  while (!resources.is_at_end()) {
    resources.take(4);  // a signature
    const unsigned id = resources.word();
    const std::size_t name = resources.byte();
    resources.take(name + (name + 1) % 2);
    const std::uint32_t length = resources.long_word();
    PhotoshopBytes resource(resources.take(length));
    if (length % 2 == 1) resources.take(1);
    if (id != kVersionInfo) continue;
    resource.long_word();
    return resource.byte() != 0;
  }
  return true;
}

/// The first channel that is no colour is the alpha of the merged picture.
bool has_merged_alpha(PhotoshopBytes section) {
  if (section.is_at_end()) return false;
  PhotoshopBytes info = section.part();
  return !info.is_at_end() && info.signed_word() < 0;
}

}  // namespace

LayeredImage decode_photoshop(std::string_view file) {
  PhotoshopBytes bytes(file);
  const PhotoshopHead head = read_photoshop_head(bytes);
  LayerCollector layers(head.width, head.height);
  bytes.part();  // a palette
  const bool has_merged = has_merged_picture(bytes.part());
  const PhotoshopBytes section = bytes.part();
  if (head.is_8_bit_rgb())
    add_layers(read_records(section), layers);
  else
    layers.give_up("Layers that are not of 8-bit RGB colours are only read merged");
  LayeredImage painting = layers.take();
  // Where they show all, layers are more exact than the merged picture: programs do not agree on
  // whether that lies on white.
  const bool show_all = !painting.layers.empty() && painting.notices.empty();
  if (show_all || (!has_merged && !painting.layers.empty()))
    painting.merged = composed(painting);
  else
    painting.merged = read_merged(bytes, head, has_merged_alpha(section));
  return painting;
}

}  // namespace foldless
