// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/export/vector_pane.h"
#include "render/camera.h"
#include "render/markers.h"

namespace foldless {

/// Markers with their rims and soft shadows; `scene` says where its local frame lies in the pane.
void draw_markers(const VectorPane& pane, const MarkerScene& scene,
                  const std::vector<Marker>& markers);

/// Handles, targets and the lines to them.
void draw_handles(const VectorPane& pane, const MarkerScene& scene);

}  // namespace foldless
