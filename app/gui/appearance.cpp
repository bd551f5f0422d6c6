// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/appearance.h"

#include <imgui.h>

namespace foldless {
namespace {

const Palette& palette_of(Theme theme) {
  switch (theme) {
    case Theme::light: return light_palette();
    case Theme::contrast: return contrast_palette();
    case Theme::dark: break;
  }
  return dark_palette();
}

}  // namespace

Appearance::Appearance(UiRenderer& renderer, Tooltips& tooltips) : renderer_(&renderer) {
  look_.tooltips = &tooltips;
}

Appearance::Change Appearance::follow(const Settings& settings, float content_scale) {
  const auto scale = content_scale * static_cast<float>(settings.scale);
  const Palette& palette = palette_of(settings.theme);
  const bool is_first = look_.fonts.text == nullptr;
  const bool has_new_scale = scale != look_.scale;
  const bool has_new_glyphs = glyphs_.all().size() != known_glyphs_;
  if (!is_first && !has_new_scale && !has_new_glyphs && &palette == look_.palette)
    return Change::none;
  if (is_first || has_new_scale || has_new_glyphs) {
    look_.fonts = build_fonts(scale, glyphs_.all());
    renderer_->upload_fonts(*ImGui::GetIO().Fonts);
    known_glyphs_ = glyphs_.all().size();
  }
  look_.scale = scale;
  look_.palette = &palette;
  apply_theme(palette, scale);
  return has_new_scale && !is_first ? Change::scale : Change::words;
}

}  // namespace foldless
