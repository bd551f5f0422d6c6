// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/energy/density.h"
#include "core/iteration.h"
#include "core/mesh/mesh_pair.h"
#include "core/scene/parameters.h"
#include "core/snapshot.h"
#include "core/stage_times.h"

namespace foldless {

/// What flips and splits are told from when a mesh has been remeshed before.
struct OriginalMesh {
  std::shared_ptr<const Triangles> triangles;  ///< 3 × #F
  int vertices = 0;                            ///< later vertices came from splits
};

/// What a run starts from: a valid mesh pair, the handles and the energy. Handles name vertices
/// of `mesh`, no vertex twice. A method, unlike Run, wants a mesh that moves as a whole: no vertex
/// without a triangle, no component without a handle, and a rest diagonal of about 1.
struct Problem {
  MeshPair mesh;
  const Density* energy = nullptr;  ///< a row of densities()
  std::vector<Handle> handles;
  Parameters parameters;
  std::optional<OriginalMesh> original = std::nullopt;  ///< absent: `mesh` itself
  /// From the frame of the rest mesh to that of the deformed one and of the targets.
  Vec2 offset = Vec2::Zero();

  /// Where the vertices are while nothing is deformed, 2 × #V.
  Points at_rest() const { return mesh.rest().colwise() + offset; }
};

/// A run of one method on one problem that can be stepped, and paused for as long as one likes.
/// Units and frame are the problem's.
///
/// Cancellation: step() notices the stop token between factorizations, returns nothing, and
/// leaves the last valid mesh; calling step() again goes on from there.
/// Every mesh that mesh() returns is locally injective, unless the row of methods() says that the
/// method may fold.
class Method {
 public:
  Method() = default;
  virtual ~Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// One vertex update. Nothing when the run has ended (see outcome()) or the token was set.
  virtual std::optional<Iteration> step(const std::stop_token& token) = 0;
  /// How the run ended; nothing while step() can still make progress.
  virtual std::optional<Outcome> outcome() const = 0;
  /// One sentence on how the run ended where outcome() does not say it all; may be empty.
  virtual std::string verdict() const { return {}; }

  virtual const MeshPair& mesh() const = 0;
  /// Moves the targets, in the order of the problem's handles; an ended run begins again from
  /// its current mesh. 2 × #handles.
  virtual void set_targets(const Points& targets) = 0;
  /// Where the processor time went so far.
  virtual StageTimes times() const { return {}; }
};

}  // namespace foldless
