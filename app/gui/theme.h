// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <array>

namespace foldless {

/// The colours of the panels in one theme, sRGB. The canvas has its own, see view_options.h.
struct Palette {
  ImVec4 window;  ///< side panels
  ImVec4 bar;     ///< menu bar, status bar
  ImVec4 popup;
  ImVec4 border;  ///< between parts of the window
  ImVec4
      outline;  ///< of controls: three times as bright as what is round them, or more [WCAG 1.4.11]
  ImVec4 text;
  ImVec4 dim;     ///< secondary text: labels, units, shortcuts
  ImVec4 frame;   ///< input fields and idle buttons
  ImVec4 hover;   ///< what the mouse is over
  ImVec4 press;   ///< what is being pressed
  ImVec4 accent;  ///< what is chosen, and the one main button
  ImVec4 on_accent;
  ImVec4 good;     ///< converged, proved
  ImVec4 busy;     ///< solving
  ImVec4 warning;  ///< blocked, unsaved, an error
  ImVec4 caution;  ///< ground of what folds
  ImVec4 on_caution;
  std::array<ImVec4, 4> series;  ///< curves of the plots, told apart without red and green
};

/// Opacity of the shade over what a dialog covers.
inline constexpr float kDimmed = 0.45F;

/// The palettes by theme: dark, light and high contrast, in the order of the theme setting.
const Palette& dark_palette();
const Palette& light_palette();
const Palette& contrast_palette();

/// Sets the current context's style: colours of the palette, spacing and rounding for `scale`
/// (framebuffer pixels in one design pixel).
void apply_theme(const Palette& palette, float scale);

/// `colour` with its opacity multiplied by `opacity`, packed for an ImDrawList.
ImU32 packed(const ImVec4& colour, float opacity = 1.0F);

}  // namespace foldless
