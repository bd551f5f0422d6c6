// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "app/editor/document.h"
#include "core/scene/scene.h"
#include "render/camera.h"
#include "render/view_options.h"

namespace foldless {

/// The document of a scene that was read from `file`: its state where there is one, else the
/// undeformed mesh with its handles.
Document document_of(const Scene& scene, const std::filesystem::path& file);

/// The scene to write to `file`: the original mesh inline, the pose as state, the view beside it.
/// Precondition: not empty.
Scene scene_of(const Document& document, const std::filesystem::path& file,
               std::shared_ptr<const nlohmann::json> view);

/// The names of the layers that are on, as an array.
nlohmann::json layers_json(const Layers& layers);
/// The layers that an array names; those of `otherwise` where it is none.
Layers read_layers(const nlohmann::json& names, const Layers& otherwise);

/// Camera and what is drawn, as a scene file keeps them. Theme and scale of the interface are the
/// user's, not the scene's, and left out.
nlohmann::json view_json(const Camera& camera, const ViewOptions& options);

/// Takes over what a scene file kept; what is missing or makes no sense is passed over. Returns
/// whether there was a camera.
bool read_view(const nlohmann::json& view, Camera& camera, ViewOptions& options);

}  // namespace foldless
