// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/file_sketch.h"

#include <array>
#include <exception>
#include <utility>

#include "app/editor/scene_document.h"
#include "core/files/mesh_io.h"
#include "core/method/methods.h"
#include "core/scene/scene_io.h"
#include "render/image.h"

namespace foldless {
namespace {

constexpr std::uintmax_t kLargestFile = 30'000'000;  // bytes

/// A rectangle of the image's proportions.
FileSketch sketch_of_image(const std::filesystem::path& file) {
  FileSketch sketch{nullptr, whole_texture(load_image(file)), std::nullopt, nullptr};
  const Image& image = sketch.image->front().levels->front();
  Shape shape;
  shape.triangles = Triangles::Map(std::array{0, 1, 2, 0, 2, 3}.data(), 3, 2);
  shape.rest.resize(2, 4);
  shape.rest << 0, image.width, image.width, 0,  //
      0, 0, image.height, image.height;
  sketch.pose = document_of(std::move(shape), "").pose;
  return sketch;
}

FileSketch sketch_of_scene(const std::filesystem::path& file) {
  const Document document = document_of(load_scene(file, method_names()).scene, file);
  auto pose = std::make_shared<Snapshot>(*document.pose);
  pose->handles = document.handles;
  FileSketch sketch{std::move(pose), nullptr, document.texture_box, document.parts};
  if (!document.texture.empty())
    sketch.image = load_texture(document.texture, document.parts.get()).pieces;
  return sketch;
}

FileSketch sketch_of_mesh(const std::filesystem::path& file) {
  LoadedMesh mesh = read_mesh(file);
  return {document_of(Shape{std::move(mesh.triangles), std::move(mesh.points)}, "").pose, nullptr,
          std::nullopt, nullptr};
}

}  // namespace

FileSketch sketch_of(const std::filesystem::path& file) {
  try {
    if (std::filesystem::file_size(file) > kLargestFile) return {};
    if (is_image_file(file)) return sketch_of_image(file);
    return is_mesh_file(file) ? sketch_of_mesh(file) : sketch_of_scene(file);
  } catch (const std::exception&) {
    return {};  // whoever opens it is told why
  }
}

}  // namespace foldless
