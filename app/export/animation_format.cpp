// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/animation_format.h"

#include <array>

namespace foldless {
namespace {

using FormatKind = AnimationFormat::Kind;

constexpr std::array<AnimationFormat, 12> kFormats{{
    {FormatKind::film, ".png", "animated PNG"},
    {FormatKind::film, ".apng", "animated PNG"},
    {FormatKind::film, ".gif", "animated GIF"},
    {FormatKind::film, ".webp", "animated WebP"},
    {FormatKind::video, ".mp4", "MP4 video"},
    {FormatKind::video, ".webm", "WebM video"},
    {FormatKind::sheet, ".json", "sprite sheet"},
    {FormatKind::gltf, ".glb", "glTF, baked"},
    {FormatKind::spine, ".spine.json", "Spine, baked"},
    {FormatKind::godot, ".tscn", "Godot scene, baked"},
    {FormatKind::foldless, ".foldless", "Foldless animation, baked"},
    {FormatKind::folder, "", "folder of pictures"},
}};

}  // namespace

std::span<const AnimationFormat> animation_formats() { return kFormats; }

const AnimationFormat* find_animation_format(const std::filesystem::path& path) {
  const std::string name = path.filename();
  const AnimationFormat* found = nullptr;
  for (const AnimationFormat& format : kFormats) {
    const bool fits = format.ending.empty() ? !path.has_extension() : name.ends_with(format.ending);
    if (fits && (!found || format.ending.size() > found->ending.size())) found = &format;
  }
  return found;
}

std::string animation_endings() {
  std::string text;
  for (const AnimationFormat& format : kFormats)
    if (!format.ending.empty()) text.append(format.ending).append(", ");
  return text.substr(0, text.size() - 2) + " or a folder of pictures";
}

std::string name_without_ending(const std::filesystem::path& path, const AnimationFormat& format) {
  const std::string name = path.filename();
  return name.substr(0, name.size() - format.ending.size());
}

}  // namespace foldless
