// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/energy/element.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// The two triangles of a diamond, by vertex indices, counter-clockwise in both meshes.
using TrianglePair = std::array<Eigen::Vector3i, 2>;

/// (a, b, c) and (b, a, d): Ψ_ab, the tessellation as it is.
TrianglePair triangles_of(const Diamond& diamond);
/// (a, d, c) and (d, b, c): Ψ̄_ab, the tessellation with e_ab flipped into e_cd.
TrianglePair flipped_triangles_of(const Diamond& diamond);

/// Height of a rest triangle over its longest edge, in lengths of that.
double relative_height_at_rest(const MeshPair& mesh, const Eigen::Vector3i& triangle);

/// Below this relative height the corners of a rest triangle count as collinear.
inline constexpr double kLeastRelativeHeight = 1e-6;

/// True when the triangles are positive in M, and none of collinear corners.
bool is_positive_at_rest(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles);

/// True when the triangles are that and satisfy eq. 9, G > 0, in M′.
bool is_feasible(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles, double delta);
/// That, and exact predicates find them positive in both meshes.
bool is_proved_feasible(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles,
                        double delta);

/// Distortion and barrier of the triangles, without the penalty: E_ab of those of a diamond.
double energy_of(const MeshPair& mesh, std::span<const Eigen::Vector3i> triangles,
                 const EnergySettings& settings);

/// ‖∇E_ab‖_∞ / E_ab: cond of eq. 11 without ‖u‖_∞, which is the same for both tessellations of a
/// diamond. Zero where the energy is zero. [1/length]
double condition_of(const MeshPair& mesh, const TrianglePair& triangles, const Diamond& diamond,
                    const EnergySettings& settings);

}  // namespace foldless
