// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace foldless {

/// Which layers are drawn; in the order of the keys 1 … 7.
struct Layers {
  bool fill = true;       ///< checkerboard or texture
  bool wireframe = true;  ///< interior edges
  bool boundary = true;   ///< outline of the mesh
  bool heat = false;      ///< distortion of each triangle, over the fill
  bool handles = true;    ///< handles, ghosts of their targets and the lines to them
  bool remeshed = false;  ///< flipped edges blue, vertices made by splits orange
  bool rest = false;      ///< outline of the rest mesh

  bool operator==(const Layers&) const = default;
};

/// A layer's name in `--layers`, its title in menus, and its switch.
struct LayerRow {
  std::string_view name;
  std::string_view title;
  bool Layers::*shown;
};

/// Every layer; row k belongs to the key k + 1.
inline constexpr std::array<LayerRow, 7> kLayerRows{{
    {"fill", "Fill", &Layers::fill},
    {"wire", "Wireframe", &Layers::wireframe},
    {"boundary", "Boundary", &Layers::boundary},
    {"heat", "Heat map", &Layers::heat},
    {"handles", "Handles and targets", &Layers::handles},
    {"remeshed", "Flipped and split edges", &Layers::remeshed},
    {"rest", "Rest shape", &Layers::rest},
}};

/// What the heat map shows of each triangle.
enum class HeatMeasure {
  conformal,  ///< σ₁/σ₂, 1 where angles are kept
  area,       ///< A′/A
  energy      ///< ψ(J), the energy per rest area
};

/// Colours of the canvas; see theme.h.
enum class Theme { dark, light, contrast };

/// Which of the two meshes is drawn.
enum class Pose { deformed, rest };

/// What is there before the layers are drawn.
enum class Background {
  theme,        ///< the theme's canvas colour
  transparent,  ///< nothing, alpha 0
  keep          ///< whatever the framebuffer holds
};

/// How a mesh is shown: plain values that a document can keep.
struct ViewOptions {
  Layers layers;
  double checker_squares = 20;  ///< squares along the longer side of the rest mesh's box
  HeatMeasure heat_measure = HeatMeasure::conformal;
  /// Ends of the heat map's scale, to compare pictures; absent: those of the mesh.
  std::optional<std::array<double, 2>> heat_scale = std::nullopt;
  Theme theme = Theme::dark;
  Background background = Background::theme;
  Pose pose = Pose::deformed;
  double line_width = 1;  ///< factor on the widths of edges
  double ui_scale = 1;    ///< framebuffer pixels in one design pixel; widths and radii grow with it

  bool operator==(const ViewOptions&) const = default;
};

}  // namespace foldless
