// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "app/bench/bench_scene.h"
#include "app/bench/random_numbers.h"

namespace foldless {

/// A kind of scene that is feasible by construction and hard to reach: a row of hard_kinds().
struct HardKind {
  std::string_view name;
  /// Draws mesh and handles.
  Scene (*draw)(RandomNumbers& random);
};

/// Disks with their whole boundary held, to polygons that bound an immersed disk: `star`, `comb`,
/// `spiral`, `polygon`, `turned`, where each corner goes to one a quarter further round, `strip`
/// and `glued`, which lie over themselves, from a round disk; `straight`, from a square whose sides
/// have many vertices; `bent`, from a band that is bent. With handles inside of a boundary that is
/// held and stays: `swap`, which change places, and `vortices`, hundreds of which go round. With a
/// free boundary: `stretched`, small moves seen under an affine map of up to 1 : 1000.
std::span<const HardKind> hard_kinds();

/// Eighteen scenes of each kind.
inline constexpr int kHardScenes = 216;

/// Scene `index` of the suite of a seed. It does not depend on the others. Kinds come by turns, and
/// energies too, so that 60 in a row have every pair once.
BenchScene hard_scene(std::uint64_t seed, int index);

}  // namespace foldless
