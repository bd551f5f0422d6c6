// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/bake.h"

namespace foldless {

/// A baked animation as JSON lines: one with the mesh, the times and what the proof came to, then
/// one a frame. Numbers are the shortest that read back exactly, so that the proof holds for what
/// is read.
std::string baked_text(const BakedAnimation& animation, const std::vector<BakedFailure>& failures);

/// Reads what baked_text() wrote. The rest mesh is locally injective; whether the frames are, and
/// what is between them, is for failures_of() to find. Throws Error `FILE:LINE: ...`.
BakedAnimation read_baked(const std::filesystem::path& file);

}  // namespace foldless
