// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace foldless {

/// A scene of a suite.
struct BenchScene {
  std::string name;        ///< unique in its suite; fit for a file name
  std::string difficulty;  ///< of the random suite; empty elsewhere
  Scene scene;
  std::vector<Points> targets = {};  ///< of a drag, frame by frame; else empty
};

}  // namespace foldless
