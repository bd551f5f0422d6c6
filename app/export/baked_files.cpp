// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/baked_files.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/export/godot.h"
#include "app/export/spine.h"
#include "core/files/atomic_file.h"
#include "core/files/staged.h"
#include "core/scene/baked_io.h"

namespace foldless {
namespace {

constexpr double kPixels = 1024;  ///< along the longer side of a drawing without a picture

/// Names that files refer to each other by: without what the formats give a meaning to.
std::string safe_name(std::string name) {
  std::ranges::replace_if(
      name,
      [](char c) {
        return static_cast<unsigned char>(c) < ' ' ||
               std::string_view(":\"\\").find(c) != std::string_view::npos;
      },
      '_');
  return name;
}

std::vector<GltfPiece> pieces_in_pixels(const BakedAnimation& animation, const BakedLook& look) {
  std::vector<GltfPiece> pieces = look.pieces;
  const auto in_units = [&](const glm::dvec2& p) {
    return (p - glm::dvec2(look.units.origin.x(), look.units.origin.y())) / look.units.pixel;
  };
  for (GltfPiece& piece : pieces) {
    piece = without_tiles(animation, piece);
    piece.place = {in_units(piece.place.min), in_units(piece.place.max)};
  }
  return pieces;
}

void add_pictures(BakedFiles& files, const std::vector<GltfPiece>& pieces,
                  const std::string& name) {
  for (std::size_t i = 0; i < pieces.size(); ++i)
    files.others.push_back({picture_name(name, i, pieces.size()), encode_png(pieces[i].image)});
}

}  // namespace

EngineUnits engine_units(const Points& rest, const std::vector<GltfPiece>& pieces) {
  const Vec2 least = rest.rowwise().minCoeff(), most = rest.rowwise().maxCoeff();
  EngineUnits units{0.5 * (least + most), (most - least).maxCoeff() / kPixels};
  if (!pieces.empty() && !pieces.front().is_tiled) {
    const GltfPiece& first = pieces.front();
    units.pixel = (first.place.max.x - first.place.min.x) / first.image.width;
  }
  return units;
}

BakedFiles baked_files(const std::filesystem::path& path, const AnimationFormat& format,
                       const BakedAnimation& animation, const BakedLook& look) {
  using Kind = AnimationFormat::Kind;
  BakedFiles files;
  if (format.kind == Kind::foldless) {
    files.failures = failures_of(animation);
    files.main = baked_text(animation, files.failures);
    return files;
  }
  if (format.kind == Kind::gltf) {
    files.failures = failures_of(in_single_precision(animation));
    files.main = gltf_binary(animation, look.pieces, held_steps(files.failures));
    return files;
  }
  const BakedAnimation rounded = in_pixels(animation, look.units);
  files.failures = failures_of(rounded);
  const HeldSteps held = held_steps(files.failures);
  const std::vector<GltfPiece> pieces = pieces_in_pixels(animation, look);
  const std::string name = safe_name(name_without_ending(path, format));
  add_pictures(files, pieces, name);
  if (format.kind == Kind::godot) {
    files.main = godot_scene(rounded, pieces, name, held);
    return files;
  }
  SpineText spine = spine_text(rounded, pieces, name, held);
  files.main = std::move(spine.json);
  files.others.push_back({name + ".atlas", std::move(spine.atlas)});
  return files;
}

void write_baked(const std::filesystem::path& path, const BakedFiles& files) {
  if (!files.others.empty()) return write_files_together(path, files.main, files.others);
  remove_leftovers(path);
  write_file_atomically(path, files.main);
}

}  // namespace foldless
