// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "render/layered/layer_collector.h"
#include "render/layered/layer_formats.h"
#include "render/layered/zip_archive.h"

namespace foldless {

// What is told of layers in every format.
inline constexpr std::string_view kBlendNote =
    "painted over what is below without their own blend mode";
inline constexpr std::string_view kGroupNote = "groups whose opacity goes to each of their layers";
inline constexpr std::string_view kMaskNote = "shown without their masks";

/// The painting of an archive that has its merged picture in mergedimage.png. `read_layers` fills
/// the collector; it is called where layers are wanted or that picture is missing. Throws Error
/// when there is neither.
LayeredImage with_merged(const ZipArchive& archive, LayeredParts parts, LayerCollector& layers,
                         const std::function<void()>& read_layers);

}  // namespace foldless
