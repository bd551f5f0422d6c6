// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/document.h"

namespace foldless {

/// Why a handle does not get to its target: what its own triangles allow when nothing else moves.
struct StuckHandle {
  int id = 0;
  int vertex = 0;
  Vec2 position = Vec2::Zero();
  Vec2 target = Vec2::Zero();
  /// Where the first triangle folds on the way to the target; nothing when none does.
  std::optional<Vec2> stop;
  std::vector<Edge> blocking;  ///< edges that the vertex would run into there
  int splits = 0;              ///< edges that the split rule would split
  bool can_flip = false;       ///< one of the blocking edges can be flipped
  bool can_split = false;

  double residual() const { return (target - position).norm(); }
};

/// "Vertex 12 is 0.4 short of its target: 2 edges stand in its way."
std::string words_of(const StuckHandle& handle);

/// The handles that are held and not at their targets, the farthest first. Precondition: a mesh
/// that is locally injective.
std::vector<StuckHandle> find_stuck_handles(const Document& document);

/// The document with the edges flipped that block a handle, as far as both meshes stay valid;
/// nothing when none can be.
std::optional<Document> with_blocking_flipped(const Document& document, int id);

/// The document with the edges split that the paper's rule splits for a handle (4.4); nothing when
/// none can be.
std::optional<Document> with_blocking_split(const Document& document, int id);

/// The stuck handles of a document whose run has ended without reaching its targets, found once a
/// pose. Costs nothing while handles are where they should be.
class StuckHandles {
 public:
  /// Brings them up to date; `has_ended` tells that the solver rests. Returns whether they changed.
  bool follow(const Document& document, bool has_ended);
  const std::vector<StuckHandle>& handles() const { return handles_; }

  /// Whether the user wants to be told.
  bool is_shown() const { return is_shown_; }
  void show(bool shown) { is_shown_ = shown; }

 private:
  std::vector<StuckHandle> handles_;
  std::shared_ptr<const Snapshot> pose_;  ///< that they are about
  std::vector<Handle> targets_;
  bool is_shown_ = true;
};

}  // namespace foldless
