// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/error.h>
#include <foldless/iteration.h>
#include <foldless/mesh.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foldless {

class PointMap;

/// How to solve.
struct SolveOptions {
  std::string energy = "arap";  ///< distortion that is minimised, a name of energies()
  std::optional<double>
      time_limit;  ///< processor time of the solving thread, > 0; absent: none [s]
  /// That share the work on large meshes, ≥ 1; the result is the same bits with any number.
  int threads = 1;
  /// No flip and no split: `triangles` of the result are those of the input, and what cannot be
  /// reached with them is not reached. Algorithm 1 of [JHT14] without its remeshing.
  bool fixed_triangulation = false;
  /// Weight of the barrier that keeps triangles from collapsing, > 0; absent: the method's default.
  std::optional<double> beta;
};

/// A mesh M and its image M′: the piecewise linear map that takes one to the other is locally
/// injective, proved with exact predicates. Lengths are those of the input.
struct Result {
  PointMatrix rest;                ///< M, #U × 2; the vertices of the input come first
  TriangleMatrix triangles;        ///< of both, #F × 3
  PointMatrix deformed;            ///< M′, #U × 2
  Parents parents;                 ///< how `rest` lies in the input mesh
  std::optional<Outcome> outcome;  ///< how the run ended; absent: it can go on
  std::string verdict;             ///< one sentence on that where there is more to say
  bool is_reached = false;         ///< ‖P‖² ≤ 1e-10 D²: every handle is at its target
  std::vector<Iteration> log;      ///< a record a vertex update since the targets were set

  /// Where points of the input mesh go, #P × 2 → #P × 2. What is outside of it by no more than
  /// 1e-12 of its bounding box's diagonal counts as inside. Where the input mesh lies over itself,
  /// the triangle of the least index is meant; the other function tells sheets apart. Throws Error
  /// for a point outside. Any thread may call it.
  PointMatrix map(const PointsRef& points) const;
  /// The same for points in given triangles of the input mesh, #P, at barycentric coordinates,
  /// #P × 3. Throws Error for coordinates below −1e-9 or whose sum is not 1.
  PointMatrix map(const IndicesRef& triangles, const CoordinatesRef& coordinates) const;

  std::shared_ptr<const PointMap> point_map;  ///< what map() asks; nothing for callers
};

/// Deforms a mesh so that handles come to their targets without a fold; see Session for a run that
/// one can watch, lead and stop.
/// `rest`: #V × 2, flat and locally injective. `triangles`: #F × 3, an oriented manifold,
/// counter-clockwise. `handles`: vertices, no one twice. `targets`: #handles × 2, where they go.
/// Throws Error with one sentence when any of that is not so. Same input, same bits, unless a time
/// limit stops it. A handle that cannot be reached is no error: see Result::is_reached and verdict.
Result solve(const PointsRef& rest, const TrianglesRef& triangles, const std::vector<int>& handles,
             const PointsRef& targets, const SolveOptions& options = {});

}  // namespace foldless
