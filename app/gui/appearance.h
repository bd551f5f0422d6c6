// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/glyphs.h"
#include "app/gui/look.h"
#include "app/gui/settings.h"
#include "render/ui_renderer.h"

namespace foldless {

/// How the interface looks: the user's theme and scale, and fonts with the characters that are
/// needed. Needs a current ImGui context.
class Appearance {
 public:
  explicit Appearance(UiRenderer& renderer, Tooltips& tooltips);

  enum class Change { none, words, scale };
  /// Brings the look up to date. `content_scale`: pixels in a design pixel that the desktop asks
  /// for. Says whether everything has to be laid out anew, at another scale or as it was.
  Change follow(const Settings& settings, float content_scale);

  const Look& look() const { return look_; }
  /// The characters that are to be shown from the next follow() on.
  Glyphs& glyphs() { return glyphs_; }

 private:
  UiRenderer* renderer_;
  Look look_;
  Glyphs glyphs_;
  std::size_t known_glyphs_ = 0;  ///< those that the fonts were made for
};

}  // namespace foldless
