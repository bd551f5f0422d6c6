// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/snapshot.h"
#include "render/figure_options.h"
#include "render/image.h"

namespace foldless {

/// Formats of figures that stay sharp at any size.
enum class VectorFormat { svg, pdf };

/// By the ending of a name, `.svg` or `.pdf`.
std::optional<VectorFormat> vector_format_of(const std::filesystem::path& file);

/// The figure of render_figure() as the bytes of a file of lines and areas, with the same layers,
/// colours, widths and order of what covers what; `samples` is of no account. A pixel is 1/96 inch.
/// An image is embedded once, whole. `texts` name it: `Scene` is its title. The same figure has the
/// same bytes. Any thread. Throws Error on a size above 16384 pixels a side.
std::string vector_figure(VectorFormat format, const Snapshot& snapshot,
                          const FigureOptions& options, const ImageTexts& texts = {});

/// Writes vector_figure() by the ending of a name, so that a whole file or none is there. Throws
/// Error when it cannot.
void save_vector_figure(const std::filesystem::path& file, const Snapshot& snapshot,
                        const FigureOptions& options, const ImageTexts& texts);

}  // namespace foldless
