// SPDX-License-Identifier: GPL-3.0-or-later
// Writes all sample meshes and scenes: make_assets DIR fills DIR/meshes and DIR/scenes.
#include <cstdio>
#include <filesystem>

#include "assets/make/sample_meshes.h"
#include "assets/make/sample_scenes.h"
#include "core/files/mesh_io.h"
#include "core/scene/scene_io.h"

namespace {

void write_all(const std::filesystem::path& folder) {
  using namespace foldless;
  std::filesystem::create_directories(folder / "meshes");
  std::filesystem::create_directories(folder / "scenes");
  const std::vector<samples::SampleMesh> meshes = samples::sample_meshes();
  for (const samples::SampleMesh& mesh : meshes)
    write_mesh(folder / "meshes" / (mesh.name + ".obj"), mesh.shape.triangles, mesh.shape.rest);
  for (samples::SampleScene sample : samples::sample_scenes(meshes)) {
    sample.scene.folder = std::filesystem::absolute(folder / "scenes");
    save_scene(sample.scene, folder / "scenes" / (sample.name + ".json"));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_assets DIR\n");
    return 2;
  }
  write_all(argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_assets: %s\n", error.what());
  return 1;
}
