// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/animation_writer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/export/baked_files.h"
#include "app/export/film_output.h"
#include "app/export/gltf_pieces.h"
#include "app/export/texture_place.h"
#include "core/error.h"
#include "core/run/solved_bake.h"

namespace foldless {
namespace {

/// At most so many pictures are sampled for a palette.
constexpr std::size_t kSamples = 12;

Camera camera_for(const FramesBox& box, const std::optional<PictureSize>& size) {
  const Vec2 middle = 0.5 * (box.min + box.max);
  return Camera{{middle.x(), middle.y()}, 1 / length_of_a_pixel(box, size)};
}

/// Of several pictures, evenly spaced. False when nothing was drawn.
bool show_samples(const std::vector<SolvedFrame>& solved, const AnimationMeans& means,
                  FilmOutput& output) {
  for (std::size_t i = 0; i < solved.size(); i += solved.size() / kSamples + 1) {
    const auto picture = means.draw(*solved[i].snapshot);
    if (!picture) return false;
    output.sample(*picture);
  }
  return true;
}

void expect_no_source(const AnimationToWrite& animation, const std::filesystem::path& written) {
  const Scene& scene = *animation.scene;
  std::vector<std::filesystem::path> sources{animation.scene_file};
  for (const std::string& path : {scene.mesh_path, scene.texture_path})
    if (!path.empty()) sources.push_back(scene.folder / path);
  for (const std::filesystem::path& source : sources) {
    std::error_code ignored;  // They are not there.
    if (std::filesystem::equivalent(written, source, ignored))
      throw Error(written.string() + ": the animation is made of it; write it under another name");
  }
}

}  // namespace

FigureOptions figure_of(const AnimationToWrite& animation) {
  FigureOptions figure = animation.figure;
  const FramesBox box = box_round(animation.solved);
  const auto [width, height] = animation.size.value_or(size_for(box));
  figure.width = width;
  figure.height = height;
  figure.camera = camera_for(box, animation.size);
  figure.parts = animation.scene->parts;
  figure.texture_place = texture_place(*animation.scene);
  figure.texture = animation.texture;
  Layers plain;
  plain.wireframe = plain.handles = false;
  if (animation.texture) plain.boundary = false;
  figure.style.layers = animation.layers.value_or(plain);
  return figure;
}

void expect_no_source(const AnimationToWrite& animation) {
  expect_no_source(animation, {animation.output});
  if (animation.format.kind == AnimationFormat::Kind::sheet)
    expect_no_source(animation, {picture_of_sheet(animation.output)});
}

void keep_range(AnimationToWrite& animation, const std::array<int, 2>& range) {
  std::vector<SolvedFrame>& solved = animation.solved;
  if (static_cast<std::size_t>(range[1]) >= solved.size())
    throw Error("The frames to be written end with " + std::to_string(range[1]) +
                ", but the last is " + std::to_string(solved.size() - 1) + "; choose them anew.");
  solved.erase(solved.begin() + range[1] + 1, solved.end());
  solved.erase(solved.begin(), solved.begin() + range[0]);
  animation.loops = false;
}

bool write_pictures(const AnimationToWrite& animation, const AnimationMeans& means,
                    const std::stop_token& token) {
  const std::vector<SolvedFrame>& solved = animation.solved;
  const auto output = film_output(animation.output, {animation.fps, animation.loops, solved.size(),
                                                     animation.texts, animation.power_of_two});
  if (output->wants_samples() && !show_samples(solved, means, *output)) return false;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    if (token.stop_requested()) return false;
    const auto picture = means.draw(*solved[i].snapshot);
    if (!picture || token.stop_requested()) return false;
    output->add(*picture);
    means.progress(i + 1, solved.size());
  }
  if (token.stop_requested()) return false;
  output->finish();
  return true;
}

std::optional<WrittenBake> write_bake(const AnimationToWrite& animation, const Frames& frames,
                                      const BakeProgress& progress, const std::stop_token& token) {
  const double pixel = length_of_a_pixel(box_round(animation.solved), animation.size);
  auto baked = bake_solved(frames,
                           {animation.scene->triangles, animation.solved, animation.loops,
                            animation.tolerance * pixel, progress},
                           token);
  if (!baked || token.stop_requested()) return std::nullopt;
  BakedLook look;
  if (animation.format.kind != AnimationFormat::Kind::foldless)
    look.pieces = gltf_pieces(*animation.scene, *baked, animation.texture);
  look.units = engine_units(animation.scene->rest, look.pieces);
  BakedFiles files = baked_files(animation.output, animation.format, *baked, look);
  for (const NamedBytes& other : files.others)
    expect_no_source(animation, animation.output.parent_path() / other.name);
  write_baked(animation.output, files);
  WrittenBake written;
  written.failures = std::move(files.failures);
  written.deviation = baked->deviation / pixel;
  written.baked = std::move(*baked);
  return written;
}

}  // namespace foldless
