// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "app/cli/solved_folder.h"
#include "app/export/texture_place.h"
#include "app/export/vector_figure.h"
#include "core/error.h"
#include "core/files/mesh_io.h"
#include "core/files/text_lines.h"
#include "core/run/original_edges.h"
#include "render/figure.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

/// What is drawn, and with which image.
struct Subject {
  Snapshot snapshot;
  std::optional<fs::path> texture;
  std::optional<Box> texture_place = std::nullopt;
  std::shared_ptr<const MeshParts> parts = nullptr;
};

Snapshot snapshot_of(const Problem& problem) {
  Snapshot snapshot;
  snapshot.triangles = std::make_shared<const Triangles>(problem.mesh.triangles());
  snapshot.rest = std::make_shared<const Points>(problem.mesh.rest());
  snapshot.deformed = problem.mesh.deformed();
  const OriginalMesh& original = *problem.original;
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(
      OriginalEdges(*original.triangles, original.vertices).flipped_in(*snapshot.triangles));
  snapshot.original_vertices = original.vertices;
  snapshot.handles = problem.handles;
  return snapshot;
}

Subject subject_of(const LoadedScene& loaded) {
  print_notices(loaded.notices);
  const Scene& scene = loaded.scene;
  Subject subject{snapshot_of(problem_of(scene)), std::nullopt};
  if (!scene.texture_path.empty()) subject.texture = scene.folder / scene.texture_path;
  subject.texture_place = texture_place(scene);
  subject.parts = scene.parts;
  return subject;
}

Subject read_subject(const std::string& file) {
  if (fs::is_directory(file)) return {read_solved_folder(file), std::nullopt};
  const std::size_t comma = file.find(',');
  if (!fs::exists(file) && comma != std::string::npos)
    return {read_pair(file.substr(0, comma), file.substr(comma + 1)), std::nullopt};
  return subject_of(is_mesh_file(file) ? scene_from_mesh(file) : load_scene_file(file));
}

}  // namespace

int render(const RenderCall& call) {
  const bool is_vector = vector_format_of(call.picture).has_value();
  if (!is_vector && call.picture.extension() != ".png")
    throw Error(call.picture.string() +
                ": pictures are written as PNG, SVG or PDF; end the name with .png, .svg or .pdf");
  Subject subject = read_subject(call.file);
  if (call.texture) subject.texture = call.texture;
  FigureOptions figure = call.figure;
  if (subject.texture) figure.texture = read_texture(*subject.texture, subject.parts);
  figure.texture_place = subject.texture_place;
  figure.parts = subject.parts;
  const ImageTexts texts{{"Software", "Foldless"}, {"Scene", call.file}};
  if (is_vector)
    save_vector_figure(call.picture, subject.snapshot, figure, texts);
  else
    save_png(call.picture, render_figure(subject.snapshot, figure), texts);
  return kExitDone;
}

}  // namespace foldless
