// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/handles_to_cut.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "core/construct/free_domain.h"
#include "core/construct/held_disk.h"
#include "core/construct/pinned_disk.h"
#include "core/mesh/boundary.h"
#include "core/method/foldless/prescribed_regions.h"

namespace foldless {
namespace cutting {

/// Of handles; a second of slits.
constexpr std::size_t kMostHandles = 200;

/// What a disk whose boundary is held has to be constructed with.
struct HeldDisk {
  PinnedVertices vertices;
  Points targets;
};

/// What a component whose boundary may go anywhere has to be constructed with.
struct FreeDomain {
  PinnedDomain vertices;
  Points targets;
};

std::vector<HeldDisk> held_disks(const MeshPair& rest, const Constraints& constraints) {
  std::vector<HeldDisk> disks;
  for (const PrescribedRegion& region : prescribed_regions(rest, constraints)) {
    const std::size_t inside = region.inside.size();
    if (region.euler_characteristic != 1 || region.loops.size() != 1 || inside == 0 ||
        inside > kMostHandles ||
        region.loops.front().size() > static_cast<std::size_t>(kMostCornersOfADisk))
      continue;
    const std::vector<int>& loop = region.loops.front();
    std::vector<int> pinned = loop;
    pinned.insert(pinned.end(), region.inside.begin(), region.inside.end());
    Points targets = constraints.targets(Eigen::all, pinned);
    if (targets == rest.deformed()(Eigen::all, vertices_of(pinned, constraints))) continue;
    disks.push_back({{vertices_of(loop, constraints), vertices_of(region.inside, constraints)},
                     std::move(targets)});
  }
  return disks;
}

/// With handles, the last ones, at all of the boundary.
Constraints with_boundary(const MeshPair& rest, Constraints constraints) {
  const auto neighbours = boundary_neighbours(rest.triangles(), rest.vertex_count());
  const std::vector<bool> is_held = have_hard_handles(constraints, rest.vertex_count());
  const Eigen::Index handles = constraints.targets.cols();
  for (int v = 0; v < rest.vertex_count(); ++v) {
    const auto place = static_cast<std::size_t>(v);
    if (neighbours[place].are_there() && !is_held[place]) constraints.vertices.push_back(v);
  }
  constraints.soft.resize(constraints.vertices.size(), false);
  constraints.targets.conservativeResize(Eigen::NoChange, constraints.count());
  for (Eigen::Index i = handles; i < constraints.targets.cols(); ++i)
    constraints.targets.col(i) =
        rest.deformed().col(constraints.vertices[static_cast<std::size_t>(i)]);
  return constraints;
}

std::vector<FreeDomain> free_domains(const MeshPair& rest, const Constraints& handles) {
  const Constraints constraints = with_boundary(rest, handles);
  std::vector<FreeDomain> domains;
  for (const PrescribedRegion& region : prescribed_regions(rest, constraints)) {
    std::vector<int> pinned = region.inside;
    PinnedDomain domain;
    bool is_free = false;
    for (const std::vector<int>& loop : region.loops) {
      domain.loops.push_back(vertices_of(loop, constraints));
      for (const int handle : loop) {
        if (handle < handles.count())
          pinned.push_back(handle);
        else
          is_free = true;
      }
    }
    if (!is_free || pinned.empty() || pinned.size() > kMostHandles) continue;
    domain.pinned = vertices_of(pinned, constraints);
    Points targets = constraints.targets(Eigen::all, pinned);
    if (targets == rest.deformed()(Eigen::all, domain.pinned)) continue;
    domains.push_back({std::move(domain), std::move(targets)});
  }
  return domains;
}

}  // namespace cutting

int handles_to_cut(const MeshPair& rest, const Constraints& constraints, CutBoundary boundary) {
  std::size_t count = 0;
  if (boundary == CutBoundary::held) {
    for (const cutting::HeldDisk& disk : cutting::held_disks(rest, constraints))
      count += disk.vertices.inside.size();
  } else {
    for (const cutting::FreeDomain& domain : cutting::free_domains(rest, constraints))
      count += domain.vertices.pinned.size();
  }
  return static_cast<int>(count);
}

std::optional<MeshPair> cut_open(MeshPair rest, const Constraints& constraints,
                                 CutBoundary boundary, int choice) {
  const auto go_on_with = [&rest](std::optional<MeshPair> next) {
    if (!next) return false;
    rest = *std::move(next);
    return true;
  };
  if (boundary == CutBoundary::free)
    for (const auto& [vertices, targets] : cutting::free_domains(rest, constraints))
      if (!go_on_with(with_free_domain(rest, vertices, targets, choice))) return std::nullopt;
  for (const auto& [vertices, targets] : cutting::held_disks(rest, constraints))
    if (!go_on_with(with_pinned_disk(rest, vertices, targets, choice))) return std::nullopt;
  return rest;
}

}  // namespace foldless
