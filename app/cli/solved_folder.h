// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/mesh_io.h"
#include "core/snapshot.h"

namespace foldless {

/// The meshes of a map; the positions are still to be judged.
struct MeshFiles {
  LoadedMesh rest;
  LoadedMesh deformed;
};

/// Reads both meshes of a map. Throws Error when their triangles are not the same.
MeshFiles read_mesh_files(const std::filesystem::path& rest, const std::filesystem::path& deformed);

/// A map from two mesh files, without handles. Throws Error when the rest mesh is not locally
/// injective; where the deformed one is not, the snapshot says so.
Snapshot read_pair(const std::filesystem::path& rest, const std::filesystem::path& deformed);

/// What `solve` left in a folder: the map, and from the report handles, flipped edges and what
/// was there before splits. Throws Error.
Snapshot read_solved_folder(const std::filesystem::path& folder);

}  // namespace foldless
