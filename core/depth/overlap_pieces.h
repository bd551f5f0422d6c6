// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/depth/overlaps.h"

namespace foldless {

/// The connected pieces of an overlap: from one pair of overlapping triangles to the next, one of
/// the two triangles stays and the other goes on over an edge; where edges of both sheets coincide
/// the way goes over a contact. In a piece two sheets lie over each
/// other, and which of them is meant by `a` and which by `b` is followed over the whole piece.
struct OverlapPieces {
  std::vector<int> piece;          ///< of every pair, in [0, count)
  std::vector<bool> is_swapped;    ///< of every pair: its `a` is of the sheet of the others' `b`
  std::vector<bool> is_one_sided;  ///< of every piece: its sheets cannot be told apart
  int count = 0;
};

/// `overlaps` as OverlapSearch finds them.
OverlapPieces overlap_pieces(const Triangles& triangles, std::span<const Overlap> overlaps);

}  // namespace foldless
