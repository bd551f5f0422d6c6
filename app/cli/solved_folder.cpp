// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/solved_folder.h"

#include <memory>
#include <string>

#include "app/cli/result_folder.h"
#include "core/error.h"
#include "core/files/atomic_file.h"
#include "core/mesh/injective.h"
#include "core/scene/handle_kind.h"
#include "core/scene/json_value.h"

namespace foldless {
namespace {

namespace fs = std::filesystem;

void expect_injective(const fs::path& file, const InjectivityReport& report) {
  if (report.is_injective_inside()) return;
  throw Error(file.string() + ": the mesh is folded (" + std::to_string(report.inverted) +
              " inverted and " + std::to_string(report.degenerate) + " degenerate triangles, " +
              std::to_string(report.branch_vertices) + " vertices covered more than once)");
}

int vertex_below(const JsonValue& value, Eigen::Index count) {
  const int vertex = value.integer();
  if (vertex < 0 || vertex >= count)
    value.refuse("is " + value.shown() + ", but the mesh has " + std::to_string(count) +
                 " vertices");
  return vertex;
}

Handle read_handle(const JsonValue& value, Eigen::Index vertex_count) {
  Handle handle;
  handle.vertex = vertex_below(value.at("vertex"), vertex_count);
  handle.target = value.at("target").point();
  if (const auto kind = value.find("kind")) {
    const auto known = handle_kind(kind->text());
    if (!known) kind->refuse("is " + kind->shown() + ", but must be drag, pin or soft");
    handle.kind = *known;
  }
  if (const auto weight = value.find("weight")) handle.weight = weight->number();
  if (const auto depth = value.find("depth")) handle.depth = depth->number();
  return handle;
}

}  // namespace

MeshFiles read_mesh_files(const fs::path& rest, const fs::path& deformed) {
  MeshFiles files{read_mesh_of_any_shape(newest_of_result(rest)),
                  read_mesh_of_any_shape(newest_of_result(deformed))};
  const auto count = [](const LoadedMesh& mesh) {
    return std::to_string(mesh.points.cols()) + " vertices and " +
           std::to_string(mesh.triangles.cols()) + " triangles";
  };
  if (files.rest.points.cols() != files.deformed.points.cols() ||
      files.rest.triangles.cols() != files.deformed.triangles.cols())
    throw Error(deformed.string() + ": has " + count(files.deformed) + ", but " + rest.string() +
                " has " + count(files.rest));
  if (files.rest.triangles != files.deformed.triangles)
    throw Error(deformed.string() + ": its triangles are not those of " + rest.string());
  return files;
}

Snapshot read_pair(const fs::path& rest, const fs::path& deformed) {
  MeshFiles files = read_mesh_files(rest, deformed);
  const InjectivityChecker checker(files.rest.triangles,
                                   static_cast<int>(files.rest.points.cols()));
  expect_injective(rest, checker.check(files.rest.points));
  const InjectivityReport report = checker.check(files.deformed.points);
  Snapshot snapshot;
  snapshot.folded_triangles = report.inverted + report.degenerate;
  snapshot.branch_vertices = report.branch_vertices;
  snapshot.overlapping_boundary_vertices =
      static_cast<int>(report.overlapping_boundary_vertices.size());
  snapshot.original_vertices = static_cast<int>(files.rest.points.cols());
  snapshot.triangles = std::make_shared<const Triangles>(std::move(files.rest.triangles));
  snapshot.rest = std::make_shared<const Points>(std::move(files.rest.points));
  snapshot.deformed = std::move(files.deformed.points);
  snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>();
  return snapshot;
}

Snapshot read_solved_folder(const fs::path& folder) {
  Snapshot snapshot = read_pair(folder / "rest.obj", folder / "deformed.obj");
  const fs::path file = newest_of_result(folder / "report.json");
  if (!fs::exists(file)) return snapshot;
  const std::string name = file.string();
  const JsonNode node = parse_json(read_file(file), name);
  const JsonValue report(node, name);
  const Eigen::Index vertices = snapshot.deformed.cols();
  if (const auto count = report.find("original_vertices"))
    snapshot.original_vertices = vertex_below(*count, vertices + 1);
  if (const auto handles = report.find("handles"))
    for (const JsonValue& handle : handles->items())
      snapshot.handles.push_back(read_handle(handle, vertices));
  if (const auto edges = report.find("flipped_edges")) {
    std::vector<Edge> flipped;
    for (const JsonValue& edge : edges->items()) {
      const std::vector<JsonValue> ends = edge.items();
      if (ends.size() != 2) edge.refuse("must be two vertices");
      flipped.push_back({vertex_below(ends[0], vertices), vertex_below(ends[1], vertices)});
    }
    snapshot.flipped_edges = std::make_shared<const std::vector<Edge>>(std::move(flipped));
  }
  return snapshot;
}

}  // namespace foldless
