// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/foldless/workspace.h"

namespace foldless::test {

/// A square grid at rest whose boundary is held, with four handles inside that change places.
inline Workspace held_frame(std::uint64_t seed) {
  constexpr int kSide = 7;
  std::mt19937_64 random(seed);
  const Shape shape = grid({.columns = kSide - 1, .rows = kSide - 1, .width = 0.7, .height = 0.7});
  std::vector<int> inside;
  std::vector<Handle> handles;
  for (int v = 0; v < kSide * kSide; ++v) {
    const int column = v % kSide, row = v / kSide;
    const bool is_boundary = column % (kSide - 1) == 0 || row % (kSide - 1) == 0;
    if (is_boundary)
      handles.push_back({.id = v, .vertex = v, .target = shape.rest.col(v)});
    else
      inside.push_back(v);
  }
  for (std::size_t left = inside.size(); left > 1; --left)
    std::swap(inside[left - 1], inside[random() % left]);
  for (std::size_t i = 0; i < 4; ++i)
    handles.push_back(
        {.id = inside[i], .vertex = inside[i], .target = shape.rest.col(inside[(i + 1) % 4])});
  const MeshPair mesh(shape.triangles, shape.rest);
  Constraints constraints = constraints_of(handles);
  EnergySettings energy{.density = find_density("arap"), .beta = 2, .delta = 1e-5};
  energy.barrier_area_weighted = true;
  NewtonSystem system(energy, mesh, constraints);
  Workspace workspace{mesh, std::move(constraints), std::move(system), 1e-3, true};
  for (const Handle& handle : handles)
    if (handle.target == shape.rest.col(handle.vertex))
      workspace.fixed_boundary.push_back(handle.vertex);
  return workspace;
}

}  // namespace foldless::test
