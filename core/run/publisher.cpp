// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/publisher.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "core/error.h"

namespace foldless {
namespace {

/// Reports on both meshes of one connectivity.
struct Proof {
  explicit Proof(const MeshPair& mesh)
      : checker(mesh.triangles(), mesh.vertex_count()),
        rest(checker.check(mesh.rest())),
        deformed(checker.check(mesh.deformed())) {}

  InjectivityChecker checker;
  InjectivityReport rest, deformed;
};

/// That of a mesh that a run may begin with.
Proof expect_injective(const MeshPair& mesh) {
  Proof proof(mesh);
  if (!proof.rest.is_injective_inside() || !proof.deformed.is_injective_inside())
    throw Error("the mesh to start from is folded; reset its pose");
  return proof;
}

std::vector<int> merged(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

/// The frame of a part that both positions survive.
Normalisation frame_of(const MeshPair& part, const InjectivityChecker& checker) {
  Normalisation frame = normalisation_for(part.rest());
  // Subtracting the offset rounds; scaling alone does not.
  if (!checker.is_injective_inside(frame.to_unit(part.deformed()))) frame.offset.setZero();
  return frame;
}

}  // namespace

// What is idle is proved with the whole and stays as it is: from there on the part is looked at.
Publisher::Publisher(const Problem& problem, ActivePart part, std::uint64_t generation)
    : original_edges_(*problem.original->triangles, problem.original->vertices),
      part_(std::move(part)),
      checker_({}, 0) {
  Proof proof = expect_injective(problem.mesh);
  const std::size_t overlaps_of_whole = proof.deformed.overlapping_boundary_vertices.size();
  MeshPair cut;
  if (!part_.is_whole()) {
    cut = part_.of(problem).mesh;
    proof = Proof(cut);
  }
  const MeshPair& mesh = part_.is_whole() ? problem.mesh : cut;
  checker_ = std::move(proof.checker);
  const std::vector<int>& overlaps = proof.deformed.overlapping_boundary_vertices;
  idle_overlaps_ = static_cast<int>(overlaps_of_whole - overlaps.size());
  overlaps_of_beginning_ = merged(overlaps, proof.rest.overlapping_boundary_vertices);
  common_.generation = generation;
  common_.original_vertices = problem.original->vertices;
  common_.revision = mesh.revision();
  share(mesh.triangles(), mesh.rest());
  if (!is_idle()) normalisation_ = frame_of(mesh, checker_);
  first_ = snapshot_of(mesh.deformed(), proof.deformed, {});
}

Problem Publisher::part_of(const Problem& problem) const {
  Problem part = part_.of(problem);
  const Points rest = normalisation_.to_unit_rest(part.mesh.rest());
  const Points deformed = normalisation_.to_unit(part.mesh.deformed());
  if (!checker_.is_injective_inside(rest) || !checker_.is_injective_inside(deformed))
    throw Error("the mesh is too large or too small for double precision; scale it");
  for (Handle& handle : part.handles) handle.target = normalisation_.to_unit(handle.target);
  part.mesh.set_positions(rest, deformed);
  part.offset = -normalisation_.scale * normalisation_.offset;
  if (const auto& stiffness = part.mesh.stiffness())
    part.mesh.set_stiffness(
        std::make_shared<const Stiffness>(stiffness->scaled(normalisation_.scale)));
  return part;
}

std::shared_ptr<Snapshot> Publisher::publish(const MeshPair& mesh, const Licence& licence) {
  if (mesh.revision() != common_.revision) {
    common_.revision = mesh.revision();
    adopt_connectivity(mesh.triangles(), normalisation_.from_unit_rest(mesh.rest()));
  }
  if (is_rest_folded_ || (does_rest_overlap_ && !licence.to_overlap)) return nullptr;
  Points deformed = normalisation_.from_unit(mesh.deformed());
  const InjectivityReport report = checker_.check(deformed);
  return snapshot_of(std::move(deformed), report, licence);
}

void Publisher::adopt_connectivity(const Triangles& triangles, const Points& rest) {
  checker_ = InjectivityChecker(triangles, static_cast<int>(rest.cols()));
  const InjectivityReport report = checker_.check(rest);
  is_rest_folded_ = !report.is_injective_inside();
  does_rest_overlap_ = has_new_overlaps(report);
  share(triangles, rest);
}

void Publisher::share(const Triangles& triangles, const Points& rest) {
  common_.triangles = std::make_shared<const Triangles>(
      part_.whole_triangles(triangles, static_cast<int>(rest.cols())));
  common_.rest = std::make_shared<const Points>(part_.whole_rest(rest));
  common_.flipped_edges =
      std::make_shared<const std::vector<Edge>>(original_edges_.flipped_in(*common_.triangles));
}

bool Publisher::has_new_overlaps(const InjectivityReport& report) const {
  return !std::ranges::includes(overlaps_of_beginning_, report.overlapping_boundary_vertices);
}

std::shared_ptr<Snapshot> Publisher::snapshot_of(Points deformed, const InjectivityReport& report,
                                                 const Licence& licence) const {
  if (!report.is_injective_inside() && !(licence.to_fold && deformed.allFinite())) return nullptr;
  if (!licence.to_overlap && has_new_overlaps(report)) return nullptr;
  auto snapshot = std::make_shared<Snapshot>(common_);
  snapshot->folded_triangles = report.inverted + report.degenerate;
  snapshot->branch_vertices = report.branch_vertices;
  snapshot->overlapping_boundary_vertices =
      static_cast<int>(report.overlapping_boundary_vertices.size()) + idle_overlaps_;
  snapshot->deformed = part_.whole_deformed(std::move(deformed));
  return snapshot;
}

}  // namespace foldless
