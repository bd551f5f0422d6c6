// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/specks.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using Piece = std::vector<std::size_t>;  // cells

/// The piece of a cell; its cells are marked as seen.
Piece piece_from(std::size_t start, const ScalarGrid& grid, std::vector<bool>& is_seen) {
  Piece piece{start};
  is_seen[start] = true;
  for (std::size_t next = 0; next < piece.size(); ++next) {
    const int width = grid.width;
    const int x = static_cast<int>(piece[next] % static_cast<std::size_t>(width));
    const int y = static_cast<int>(piece[next] / static_cast<std::size_t>(width));
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, grid.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
        const std::size_t cell = grid.index(u, v);
        if (is_seen[cell] || !(grid.values[cell] > 0)) continue;
        is_seen[cell] = true;
        piece.push_back(cell);
      }
  }
  return piece;
}

int take_away(const Piece& piece, ScalarGrid& grid) {
  for (const std::size_t cell : piece) grid.values[cell] = -grid.values[cell];
  return piece.empty() ? 0 : 1;
}

}  // namespace

int remove_specks(ScalarGrid& grid, double cells) {
  std::vector<bool> is_seen(grid.values.size());
  int removed = 0;
  Piece kept;  // the largest so far, if even that is small
  bool has_large = false;
  for (std::size_t cell = 0; cell < grid.values.size(); ++cell) {
    if (is_seen[cell] || !(grid.values[cell] > 0)) continue;
    Piece piece = piece_from(cell, grid, is_seen);
    if (static_cast<double>(piece.size()) >= cells) {
      has_large = true;
    } else {
      if (piece.size() > kept.size()) std::swap(piece, kept);
      removed += take_away(piece, grid);
    }
  }
  if (has_large) removed += take_away(kept, grid);
  return removed;
}

}  // namespace foldless
