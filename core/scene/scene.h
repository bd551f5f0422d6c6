// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/energy/density.h"
#include "core/handle.h"
#include "core/mesh/mesh_pair.h"
#include "core/mesh/parts.h"
#include "core/mesh/stiffness.h"
#include "core/mesh/triangle.h"
#include "core/motion/animation.h"
#include "core/rig/rig.h"
#include "core/scene/parameters.h"

namespace foldless {

/// Where the user left a scene: the remeshed pair as it was on screen.
struct SceneState {
  Triangles triangles;  ///< 3 × #F
  Points rest;          ///< 2 × #V, original vertices first
  Points deformed;      ///< 2 × #V
};

/// Where in the plane of the rest mesh the texture lies, as a whole.
struct TextureBox {
  Vec2 min = Vec2::Zero();  ///< lower left corner of the image
  Vec2 max = Vec2::Ones();  ///< upper right corner, greater in x and y

  bool operator==(const TextureBox&) const = default;
};

/// A scene file in memory (FORMATS: version 1). Everything is in input units.
struct Scene {
  /// Absolute folder that `mesh_path` and `texture_path` are relative to: that of the scene file,
  /// or empty while there is none.
  std::filesystem::path folder;
  std::string mesh_path;     ///< as written in the file, relative to `folder`; empty: inline
  Triangles triangles;       ///< 3 × #F of the original mesh, validated
  Points rest;               ///< 2 × #V of the original mesh
  std::string texture_path;  ///< as written, relative to `folder`; empty: checkerboard
  std::optional<TextureBox> texture_box;       ///< absent: the box of the rest mesh
  std::shared_ptr<const MeshParts> parts;      ///< that show layers of the texture; null: none
  const Density* energy = nullptr;             ///< a row of densities(); never null after loading
  std::shared_ptr<const Stiffness> stiffness;  ///< of the rest plane; null: 1 everywhere
  std::vector<Handle> handles;  ///< vertices of the original mesh, or of `state` where there is one
  Rig rig;                      ///< of the handles
  std::shared_ptr<const Animation> animation;  ///< of the handles; null: none
  Parameters parameters;
  std::optional<SceneState> state;
  /// What the editor keeps beside the state (camera, overlays); opaque to core, kept as it is.
  std::shared_ptr<const nlohmann::json> view;
  std::string description;  ///< one line on what to look at; may be empty
};

/// The mesh pair as the user left it, or the original at rest, with its stiffness.
MeshPair mesh_of(const Scene& scene);

}  // namespace foldless
