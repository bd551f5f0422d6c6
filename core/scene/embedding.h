// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/scene/scene_io.h"

namespace foldless {

/// True for an OBJ file with a file `handles.txt` beside it: a problem of the benchmarks of
/// [DAZ*20] and [DKZ*21], where `v` is the mesh at rest, `vt` a map of it that folds, and the
/// vertices in handles.txt, counted from 0, are to stay where the map has them.
bool is_embedding(const std::filesystem::path& file);

/// The scene of such a file: the handles' targets are the texture coordinates of their vertices.
/// Energy `arap`. Throws Error for a mesh that read_mesh() refuses, such as one that is not planar,
/// and for what is no handle.
LoadedScene scene_from_embedding(const std::filesystem::path& file);

}  // namespace foldless
