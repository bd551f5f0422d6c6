// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/proof.h"

#include "core/mesh/injective.h"
#include "core/mesh/orientation.h"
#include "core/mesh/quality.h"

namespace foldless {
namespace {

int inverted_triangles(const Snapshot& pose) {
  int count = 0;
  for (const auto& t : pose.triangles->colwise())
    if (orientation(*pose.rest, t) <= 0 || orientation(pose.deformed, t) <= 0) ++count;
  return count;
}

/// Counts both meshes.
void count_vertices(const Snapshot& pose, Proof& proof) {
  const InjectivityChecker checker(*pose.triangles, static_cast<int>(pose.rest->cols()));
  for (const Points* points : {pose.rest.get(), &pose.deformed}) {
    const InjectivityReport report = checker.check(*points);
    proof.branch_vertices += report.branch_vertices;
    proof.overlapping_boundary_vertices +=
        static_cast<int>(report.overlapping_boundary_vertices.size());
  }
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

Proof proof_of(const Snapshot& pose) {
  Proof proof;
  proof.triangles = static_cast<int>(pose.triangles->cols());
  proof.vertices = static_cast<int>(pose.rest->cols());
  if (proof.triangles == 0) return proof;
  proof.inverted = inverted_triangles(pose);
  count_vertices(pose, proof);
  const Quality quality = quality_of(*pose.triangles, *pose.rest, pose.deformed);
  proof.min_area_ratio = quality.min_area_ratio;
  proof.max_conformal_distortion = quality.max_conformal_distortion;
  return proof;
}

std::string fold_words(const Proof& proof) {
  if (proof.holds()) return {};
  std::string overlaps =
      counted(proof.overlapping_boundary_vertices, "boundary vertex overlaps itself",
              "boundary vertices overlap themselves");
  if (!proof.folds()) return overlaps;
  std::string words = "This map folds: ";
  if (proof.inverted > 0)
    words += counted(proof.inverted, "triangle is inverted", "triangles are inverted");
  if (proof.inverted > 0 && proof.branch_vertices > 0) words += ", ";
  if (proof.branch_vertices > 0)
    words += counted(proof.branch_vertices, "vertex is wound twice", "vertices are wound twice");
  if (proof.overlapping_boundary_vertices > 0) words += ", " + overlaps;
  return words;
}

}  // namespace foldless
