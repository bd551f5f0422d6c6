// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/publisher.h"

#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

void expect_injective(const MeshPair& mesh) {
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  if (!checker.is_injective(mesh.rest()) || !checker.is_injective(mesh.deformed()))
    throw Error("the mesh to start from is folded; reset its pose");
}

/// The frame of a part that both positions survive.
Normalisation frame_of(const MeshPair& part, const InjectivityChecker& checker) {
  Normalisation frame = normalisation_for(part.rest());
  // Subtracting the offset rounds; scaling alone does not.
  if (!checker.is_injective(frame.to_unit(part.deformed()))) frame.offset.setZero();
  return frame;
}

}  // namespace

// What is idle is proved with the whole and stays as it is: from there on the part is looked at.
Publisher::Publisher(const Problem& problem, std::uint64_t generation)
    : original_edges_(*problem.original->triangles, problem.original->vertices),
      part_(problem.mesh, problem.handles),
      checker_({}, 0) {
  expect_injective(problem.mesh);
  common_.generation = generation;
  common_.original_vertices = problem.original->vertices;
  const MeshPair part = part_.of(problem).mesh;
  common_.revision = part.revision();
  adopt_connectivity(part.triangles(), part.rest());
  if (!is_idle()) normalisation_ = frame_of(part, checker_);
  first_ = snapshot_of(part.deformed(), false);
}

Problem Publisher::part_of(const Problem& problem) const {
  Problem part = part_.of(problem);
  const Points rest = normalisation_.to_unit_rest(part.mesh.rest());
  const Points deformed = normalisation_.to_unit(part.mesh.deformed());
  if (!checker_.is_injective(rest) || !checker_.is_injective(deformed))
    throw Error("the mesh is too large or too small for double precision; scale it");
  for (Handle& handle : part.handles) handle.target = normalisation_.to_unit(handle.target);
  part.mesh.set_positions(rest, deformed);
  return part;
}

std::shared_ptr<Snapshot> Publisher::publish(const MeshPair& mesh, bool may_fold) {
  if (mesh.revision() != common_.revision) {
    common_.revision = mesh.revision();
    adopt_connectivity(mesh.triangles(), normalisation_.from_unit_rest(mesh.rest()));
  }
  return is_rest_injective_ ? snapshot_of(normalisation_.from_unit(mesh.deformed()), may_fold)
                            : nullptr;
}

void Publisher::adopt_connectivity(const Triangles& triangles, const Points& rest) {
  checker_ = InjectivityChecker(triangles, static_cast<int>(rest.cols()));
  is_rest_injective_ = checker_.is_injective(rest);
  common_.triangles = std::make_shared<const Triangles>(
      part_.whole_triangles(triangles, static_cast<int>(rest.cols())));
  common_.rest = std::make_shared<const Points>(part_.whole_rest(rest));
  common_.flipped_edges =
      std::make_shared<const std::vector<Edge>>(original_edges_.flipped_in(*common_.triangles));
}

std::shared_ptr<Snapshot> Publisher::snapshot_of(const Points& deformed, bool may_fold) const {
  const InjectivityReport report = checker_.check(deformed);
  if (!report.is_injective() && !(may_fold && deformed.allFinite())) return nullptr;
  auto snapshot = std::make_shared<Snapshot>(common_);
  snapshot->folded_triangles = report.inverted + report.degenerate;
  snapshot->branch_vertices = report.branch_vertices;
  snapshot->deformed = part_.whole_deformed(deformed);
  return snapshot;
}

}  // namespace foldless
