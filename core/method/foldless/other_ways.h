// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/method/foldless/cut_to_handles.h"
#include "core/method/foldless/transport.h"
#include "core/method/method.h"

namespace foldless {

/// One of the ways that are tried where the approach locked.
struct Way {
  enum class Kind {
    approach,   ///< from the rest state
    transport,  ///< from the rest state
    onwards,    ///< a transport from where one locked nearest to the targets; without one: nothing
    cut         ///< a map that is constructed: cut_to_handles()
  };
  Kind kind = Kind::transport;
  TransportPlan plan = {};                   ///< of a transport
  bool is_refined = false;                   ///< on a mesh whose edges were all split
  bool goes_in_rounds = false;               ///< a transport that goes on where it locks
  CutBoundary boundary = CutBoundary::held;  ///< of what is cut
  int choice = 0;                            ///< of the class of maps of a cut
};

/// What is tried, in this order: cuts of components whose boundary is free, of two classes where
/// handles are few; an approach where none has begun at rest; transports, as transport_plans() has
/// them; cuts of disks with a held boundary, of several classes where handles are few; on from the
/// nearest place where a transport locked, on the mesh as it is and on a refined one; transports in
/// random orders, in rounds; and, of a small mesh, all of the transports on a refined one. `rest`
/// is where ways begin.
std::vector<Way> other_ways(const MeshPair& rest, const Constraints& constraints,
                            bool with_approach);

/// The ways one by one, on meshes of their own.
class OtherWays {
 public:
  /// They begin at the rest state of the mesh of `problem`, which outlives them; `with_approach`:
  /// see other_ways(). Costs nothing before the first is tried: most solves, and nearly all frames
  /// of a drag, try none.
  OtherWays(const Problem& problem, bool with_approach)
      : problem_(problem), with_approach_(with_approach) {}

  bool have_ended() const { return ways_ && next_ == ways_->size(); }
  /// Precondition: one was tried, and they have not ended.
  const Way& next() const { return (*ways_)[next_]; }
  /// Whether a cut of a free boundary has arrived.
  bool has_cut_free() const { return has_cut_free_; }
  /// Tries the next way, from which `work` becomes its mesh where it arrives, and where it locks
  /// nearer to the targets. After a cut of a held disk that arrives only cuts are left.
  /// Precondition: they have not ended.
  Steps<Progress> try_next(Workspace& work);

 private:
  Steps<Progress> go(const Way& way, Workspace& work);
  void leave_only_cuts();

  const Problem& problem_;
  bool with_approach_;
  MeshPair rest_;                         ///< not deformed; from the first that is tried on
  std::optional<std::vector<Way>> ways_;  ///< likewise
  std::size_t next_ = 0;
  bool has_cut_free_ = false;
  double locked_error_ = 0;           ///< ‖P‖² of what locked nearest to the targets
  std::optional<Workspace> nearest_;  ///< where transports locked
};

}  // namespace foldless
