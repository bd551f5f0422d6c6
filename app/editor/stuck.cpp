// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/stuck.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/mesh/injective.h"
#include "core/method/satisfied.h"
#include "core/remesh/diamond_energy.h"
#include "core/remesh/split_edges.h"

namespace foldless {
namespace {

/// Halves of split edges are not shorter than this. [diagonals of the mesh]
constexpr double kShortestHalf = 1e-5;

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

SplitSettings split_settings(const Document& document) {
  SplitSettings settings;
  settings.shortest_edge = kShortestHalf * bounding_box_diagonal(document.original->rest);
  settings.delta = document.parameters.delta;
  return settings;
}

bool is_flippable(const MeshPair& mesh, int edge, double delta) {
  return !mesh.is_boundary_edge(edge) && mesh.is_flip_legal(edge) &&
         is_feasible(mesh, flipped_triangles_of(mesh.diamond(edge)), delta);
}

StuckHandle explain(const MeshPair& mesh, const Handle& handle, const Document& document) {
  StuckHandle stuck;
  stuck.id = handle.id;
  stuck.vertex = handle.vertex;
  stuck.position = position_of(document, handle);
  stuck.target = handle.target;
  const auto blockage = blockage_of(mesh, handle.vertex, stuck.target - stuck.position);
  // What folds beyond the target is in nobody's way.
  if (!blockage || (blockage->v_alpha - stuck.position).norm() > stuck.residual()) return stuck;
  stuck.stop = blockage->v_alpha;
  stuck.splits = static_cast<int>(blockage->splits.size());
  for (const int e : blockage->blocking) {
    stuck.blocking.push_back(mesh.edge(e));
    stuck.can_flip = stuck.can_flip || is_flippable(mesh, e, document.parameters.delta);
  }
  const SplitSettings settings = split_settings(document);
  stuck.can_split = std::ranges::any_of(
      blockage->splits, [&](const EdgeSplit& s) { return is_split_safe(mesh, s, settings); });
  return stuck;
}

bool is_stuck(const Document& document, const Handle& handle) {
  return handle.kind != HandleKind::soft &&
         (handle.target - position_of(document, handle)).norm() > target_tolerance(document);
}

/// The document with another connectivity, or nothing when that is not valid after all.
std::optional<Document> remeshed(const Document& document, const MeshPair& mesh) {
  if (!is_injective_inside(mesh.triangles(), mesh.rest(), mesh.deformed())) return std::nullopt;
  Document changed = document;
  changed.pose = pose_of(mesh, *document.original);
  return changed;
}

}  // namespace

std::string words_of(const StuckHandle& handle) {
  const std::string words = "Vertex " + std::to_string(handle.vertex) + " is " +
                            short_number(handle.residual()) + " short of its target: ";
  if (!handle.stop)
    return words + "its own triangles would let it go on; the mesh between the handles holds it.";
  const std::string way = short_number((*handle.stop - handle.position).norm());
  const bool is_one = handle.blocking.size() == 1;
  return words + std::to_string(handle.blocking.size()) +
         (is_one ? " edge stands" : " edges stand") + " in its way, and a triangle would fold " +
         way + " further on.";
}

std::vector<StuckHandle> find_stuck_handles(const Document& document) {
  std::vector<StuckHandle> found;
  const MeshPair mesh = mesh_of(document);
  for (const Handle& handle : document.handles)
    if (is_stuck(document, handle)) found.push_back(explain(mesh, handle, document));
  std::ranges::stable_sort(found, std::ranges::greater{}, &StuckHandle::residual);
  return found;
}

std::optional<Document> with_blocking_flipped(const Document& document, int id) {
  const Handle* handle = find_handle(document, id);
  if (!handle) return std::nullopt;
  MeshPair mesh = mesh_of(document);
  const auto blockage =
      blockage_of(mesh, handle->vertex, handle->target - position_of(document, *handle));
  if (!blockage) return std::nullopt;
  int flips = 0;
  for (const int e : blockage->blocking) {
    if (!is_flippable(mesh, e, document.parameters.delta)) continue;
    mesh.flip(e);
    ++flips;
  }
  return flips > 0 ? remeshed(document, mesh) : std::nullopt;
}

std::optional<Document> with_blocking_split(const Document& document, int id) {
  const Handle* handle = find_handle(document, id);
  if (!handle) return std::nullopt;
  MeshPair mesh = mesh_of(document);
  const Vec2 direction = handle->target - position_of(document, *handle);
  const int splits = split_edges(mesh, {{handle->vertex, direction}}, split_settings(document));
  return splits > 0 ? remeshed(document, mesh) : std::nullopt;
}

bool StuckHandles::follow(const Document& document, bool has_ended) {
  const bool had_any = !handles_.empty();
  const bool is_over = is_shown_ && has_ended && !document.is_empty() &&
                       document.standing.outcome && document.standing.outcome != Outcome::cancelled;
  if (!is_over) {
    handles_.clear();
    pose_ = nullptr;
    return had_any;
  }
  if (pose_ == document.pose && targets_ == document.handles) return false;
  pose_ = document.pose;
  targets_ = document.handles;
  handles_.clear();
  if (!is_at_targets(document) &&
      is_injective_inside(*pose_->triangles, *pose_->rest, pose_->deformed))
    handles_ = find_stuck_handles(document);
  return had_any || !handles_.empty();
}

}  // namespace foldless
