// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/injective.h"
#include "core/method/method.h"
#include "core/method/normalisation.h"
#include "core/run/active_part.h"
#include "core/run/original_edges.h"
#include "core/snapshot.h"

namespace foldless {

/// What a mesh of a method may be, by its nature, besides locally injective.
struct Licence {
  bool to_fold = false;     ///< folded or wound twice round a vertex
  bool to_overlap = false;  ///< overlapping itself at boundary vertices
};

/// What lies between a mesh as its user has it and the one that a method solves: the active part,
/// normalised. Turns what the method reaches into snapshots of the whole in input units, proved
/// locally injective with exact predicates; where the method may do otherwise, a snapshot says what
/// is wrong with it.
class Publisher {
 public:
  /// `problem` has its original mesh, and `part` is what its handles can move. Throws Error when
  /// its mesh is not locally injective, but for boundary vertices: another method may have left
  /// them.
  Publisher(const Problem& problem, ActivePart part, std::uint64_t generation);

  /// True when no handle can move anything.
  bool is_idle() const { return part_.is_empty(); }
  /// The problem that a method solves. Throws Error when it is of a size that double precision does
  /// not hold. Precondition: not idle.
  Problem part_of(const Problem& problem) const;
  const Normalisation& normalisation() const { return normalisation_; }

  /// The mesh as the problem had it.
  std::shared_ptr<const Snapshot> first() const { return first_; }
  /// A mesh of the method; nothing where it is not locally injective in input units, unless the
  /// method has licence for what is wrong with it, or the problem began with it: boundary vertices
  /// that overlapped themselves then may do so on. The rest mesh must never be folded.
  std::shared_ptr<Snapshot> publish(const MeshPair& mesh, const Licence& licence);

 private:
  /// Looks at another connectivity from now on.
  void adopt_connectivity(const Triangles& triangles, const Points& rest);
  /// What snapshots have in common.
  void share(const Triangles& triangles, const Points& rest);
  bool has_new_overlaps(const InjectivityReport& report) const;
  std::shared_ptr<Snapshot> snapshot_of(Points deformed, const InjectivityReport& report,
                                        const Licence& licence) const;

  OriginalEdges original_edges_;
  ActivePart part_;
  Normalisation normalisation_;
  InjectivityChecker checker_;  ///< of the triangles of the part
  bool is_rest_folded_ = false;
  bool does_rest_overlap_ = false;          ///< where it did not when the problem began
  std::vector<int> overlaps_of_beginning_;  ///< vertices of the part, at rest or deformed
  int idle_overlaps_ = 0;                   ///< boundary vertices of M′ that are not in the part
  Snapshot common_;  ///< what every snapshot of one connectivity has in common
  std::shared_ptr<const Snapshot> first_;
};

}  // namespace foldless
