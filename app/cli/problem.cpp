// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/problem.h"

#include <iostream>
#include <string_view>
#include <utility>

#include "core/method/methods.h"
#include "core/run/mesh_at_rest.h"
#include "core/scene/embedding.h"

namespace foldless {

LoadedScene load_scene_file(const std::filesystem::path& file) {
  return is_embedding(file) ? scene_from_embedding(file) : load_scene(file, method_names());
}

Problem problem_of(const Scene& scene) {
  Problem problem;
  problem.mesh = mesh_of(scene);
  problem.energy = scene.energy;
  problem.handles = scene.handles;
  problem.parameters = scene.parameters;
  problem.original = OriginalMesh{std::make_shared<const Triangles>(scene.triangles),
                                  static_cast<int>(scene.rest.cols())};
  return problem;
}

Problem problem_at_rest(const Scene& scene) {
  Problem problem = problem_of(scene);
  auto [mesh, handles] =
      mesh_at_rest({scene.triangles, scene.rest}, scene.handles,
                   scene.state ? scene.state->rest : scene.rest, scene.parameters.delta);
  mesh.set_stiffness(stiffness_with(scene.stiffness, handles, mesh.rest()));
  problem.mesh = std::move(mesh);
  problem.handles = std::move(handles);
  return problem;
}

std::shared_ptr<const TexturePieces> read_texture(const std::filesystem::path& file,
                                                  const std::shared_ptr<const MeshParts>& parts) {
  LoadedTexture texture = load_texture(file, parts.get());
  print_notices(texture.notices);
  return std::move(texture.pieces);
}

void print_notices(const std::vector<std::string>& notices) {
  for (const std::string& notice : notices) std::cerr << "foldless: note: " << notice << '\n';
}

}  // namespace foldless
