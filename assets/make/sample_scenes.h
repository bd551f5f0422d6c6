// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assets/make/sample_meshes.h"
#include "core/scene/scene.h"

namespace foldless::samples {

/// A scene of assets/scenes: `name`.json.
struct SampleScene {
  std::string name;
  Scene scene;
};

/// All scenes of assets/scenes, over the meshes that sample_meshes() makes.
std::vector<SampleScene> sample_scenes(const std::vector<SampleMesh>& meshes);

}  // namespace foldless::samples
