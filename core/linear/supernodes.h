// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/elimination_tree.h"

namespace foldless {

/// Nodes of an elimination tree, one after the other, that are eliminated together.
struct NodeRange {
  int first = 0;
  int nodes = 0;
  int below = 0;  ///< nodes in the rows below
};

/// Parts the nodes: those whose columns have the same rows are together, and some more where few
/// zeros are stored for it, which makes fewer and larger dense blocks [AG89].
std::vector<NodeRange> relaxed_supernodes(const EliminationTree& tree);

}  // namespace foldless
