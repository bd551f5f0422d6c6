// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "app/export/vector_figure.h"
#include "render/image.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {

/// What another program makes of a figure, a pixel of it a pixel of the picture: rsvg-convert of an
/// SVG, pdftocairo of a PDF. Nothing where that program is missing.
inline std::optional<Image> rasterised(VectorFormat format, const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string in = folder.write("figure", bytes).string();
  const std::string out = (folder / "picture").string();
  const std::string command =
      format == VectorFormat::svg
          ? "rsvg-convert --unlimited '" + in + "' -o '" + out + ".png'"
          : "pdftocairo -r 96 -png -transp -singlefile '" + in + "' '" + out + "'";
  if (std::system((command + " 2>/dev/null").c_str()) != 0) return std::nullopt;
  return load_image(out + ".png");
}

}  // namespace foldless::test
