// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
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
#include "core/outline/layers_mesh.h"
#include "core/scene/scene_io.h"
#include "render/layered/layered_image.h"

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

/// What was made of a file.
struct MeshedFile {
  ImageMesh mesh;
  std::shared_ptr<const MeshParts> parts;  ///< null: none
  Vec2 size;                               ///< of the picture, pixels
  std::vector<std::string> notices;
};

/// Errors of the outline know no file.
template <typename Make>
auto naming_the_file(const MeshCall& call, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error(call.image.string() + ": " + error.what());
  }
}

MeshedFile mesh_as_a_whole(const MeshCall& call) {
  const Image image = load_image(call.image);
  const AlphaMap alpha{image.width, image.height, alpha_of(image)};
  return naming_the_file(call, [&]() -> MeshedFile {
    return {
        *mesh_of_image(alpha, options_of(call, alpha)), nullptr, {image.width, image.height}, {}};
  });
}

MeshedFile mesh_by_layer(const MeshCall& call) {
  LayeredImage painting = load_layered(call.image);
  const std::vector<LayerAlpha> layers = layer_alphas(painting);
  const Vec2 size(painting.width, painting.height);
  return naming_the_file(call, [&]() -> MeshedFile {
    if (layers.empty())
      throw Error("has no layer that can be seen by itself; leave out --layers" +
                  (painting.notices.empty() ? "" : " (" + painting.notices.front() + ")"));
    LayersMesh made = *mesh_of_layers(layers, size, options_of(call, united(layers, size)));
    for (const std::string& name : made.left_out)
      painting.notices.push_back("nothing of the layer '" + name + "' is opaque enough");
    return {std::move(made.mesh), std::make_shared<const MeshParts>(std::move(made.parts)), size,
            std::move(painting.notices)};
  });
}

void write_scene(const MeshCall& call, const MeshedFile& made) {
  Scene scene;
  scene.folder = fs::absolute(call.output).lexically_normal().parent_path();
  scene.triangles = made.mesh.shape.triangles;
  scene.rest = made.mesh.shape.rest;
  scene.parts = made.parts;
  scene.texture_path = fs::absolute(call.image)
                           .lexically_normal()
                           .lexically_proximate(scene.folder)
                           .generic_string();
  scene.texture_box = TextureBox{Vec2::Zero(), made.size};
  scene.energy = find_density("arap");
  save_scene(scene, call.output);
}

void write(const MeshCall& call, const MeshedFile& made) {
  if (call.output.extension() == ".json") return write_scene(call, made);
  const Shape& shape = made.mesh.shape;
  if (call.output.extension() != ".obj")
    return write_mesh(call.output, shape.triangles, shape.rest);
  const Points in_image = made.size.cwiseInverse().asDiagonal() * shape.rest;
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
  const MeshedFile made = call.by_layer ? mesh_by_layer(call) : mesh_as_a_whole(call);
  write(call, made);
  print_notices(made.notices);
  print_notices(notices_of(made.mesh));
  print(made.mesh);
  return kExitDone;
}

}  // namespace foldless
