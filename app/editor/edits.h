// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/picking.h"

namespace foldless {

/// A document with one handle more.
struct Placed {
  Document document;
  int id = 0;
  bool is_new = true;  ///< false: the vertex already had the handle, the document is unchanged
};

/// Puts a handle on the mesh, at its vertex or at a new one; its target is where the vertex is.
Placed place_handle(const Document& document, const MeshHit& hit);

/// A new target of a handle. [length]
struct Target {
  int id = 0;
  Vec2 position = Vec2::Zero();
  std::optional<double> angle = std::nullopt;  ///< of its Turn, if that changes [degrees]
};

/// The document with some targets moved and turned; ids it does not have are passed over.
Document with_targets(Document document, const std::vector<Target>& targets);

/// The document without some handles: their bones become shorter. The mesh stays as it is.
Document without_handles(Document document, const std::set<int>& ids);

/// The undeformed original mesh with the same handles, their targets where they are at rest.
/// Vertices that were made for handles are made again.
Document in_rest_pose(const Document& document);

}  // namespace foldless
