// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "core/energy/densities.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/files/mesh_io.h"
#include "core/files/mesh_source.h"
#include "core/files/mesh_text.h"
#include "core/outline/image_mesh.h"
#include "core/scene/scene_io.h"
#include "render/image.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

ImageMeshOptions options_of(const MeshCall& call, const AlphaMap& alpha) {
  ImageMeshOptions options = options_for(alpha);
  options.threshold = call.threshold.value_or(options.threshold);
  options.margin = call.margin.value_or(options.margin);
  options.simplify = call.simplify.value_or(options.simplify);
  options.edge_length = call.edge_length.value_or(options.edge_length);
  options.min_angle = call.min_angle.value_or(options.min_angle);
  return options;
}

/// Errors of the outline know no file.
ImageMesh mesh_of(const MeshCall& call, const AlphaMap& alpha) {
  try {
    return *mesh_of_image(alpha, options_of(call, alpha));
  } catch (const Error& error) {
    throw Error(call.image.string() + ": " + error.what());
  }
}

void write_scene(const MeshCall& call, const Shape& shape, const Vec2& size) {
  Scene scene;
  scene.folder = fs::absolute(call.output).lexically_normal().parent_path();
  scene.triangles = shape.triangles;
  scene.rest = shape.rest;
  scene.texture_path = fs::absolute(call.image)
                           .lexically_normal()
                           .lexically_proximate(scene.folder)
                           .generic_string();
  scene.texture_box = TextureBox{Vec2::Zero(), size};
  scene.energy = find_density("arap");
  save_scene(scene, call.output);
}

void write(const MeshCall& call, const Shape& shape, const Vec2& size) {
  if (call.output.extension() == ".json") return write_scene(call, shape, size);
  if (call.output.extension() != ".obj")
    return write_mesh(call.output, shape.triangles, shape.rest);
  const Points in_image = size.cwiseInverse().asDiagonal() * shape.rest;
  write_file_atomically(call.output, textured_obj_text(shape.triangles, shape.rest, in_image));
}

void print(const ImageMesh& mesh) {
  std::array<char, 16> angle{};
  std::snprintf(angle.data(), angle.size(), "%.1f", mesh.min_angle);
  std::cout << counted(static_cast<std::size_t>(mesh.shape.rest.cols()), "vertex") << ", "
            << counted(static_cast<std::size_t>(mesh.shape.triangles.cols()), "triangle")
            << ", smallest angle " << angle.data() << " degrees, "
            << counted(static_cast<std::size_t>(mesh.parts), "part") << ", "
            << counted(static_cast<std::size_t>(mesh.holes), "hole") << '\n';
}

std::vector<std::string> notices_of(const ImageMesh& mesh) {
  std::vector<std::string> notices;
  if (mesh.specks > 0)
    notices.push_back(counted(static_cast<std::size_t>(mesh.specks), "speck") +
                      " of a few pixels left out");
  if (mesh.filled_holes > 0)
    notices.push_back(counted(static_cast<std::size_t>(mesh.filled_holes), "hole") +
                      " of a few pixels filled");
  return notices;
}

}  // namespace

int mesh(const MeshCall& call) {
  if (call.output.extension() != ".json" && !is_mesh_file(call.output))
    throw Error(call.output.string() +
                ": end the name with .json for a scene, or with .obj, .off " +
                "or .ply for a mesh");
  const Image image = load_image(call.image);
  const AlphaMap alpha{image.width, image.height, alpha_of(image)};
  const ImageMesh result = mesh_of(call, alpha);
  write(call, result.shape, {image.width, image.height});
  print_notices(notices_of(result));
  print(result);
  return kExitDone;
}

}  // namespace foldless
