// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace foldless {

/// What reached the graphics card since a renderer was made.
struct RenderStats {
  std::uint64_t index_uploads = 0;     ///< uploads of triangles, edges and rest positions
  std::uint64_t position_uploads = 0;  ///< uploads of the positions that are drawn
};

}  // namespace foldless
