// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/editor/editor.h"
#include "app/gui/animation_export.h"
#include "app/gui/look.h"

namespace foldless {

/// What an animation is written as, and how: a part of the export dialog.
class AnimationOptions {
 public:
  AnimationOptions();

  /// The dialog opens.
  void open();
  /// `is_transparent` is chosen for pictures of every kind.
  void draw(const Editor& editor, bool& is_transparent, const Look& look);

  const AnimationFormat& format() const;
  AnimationChoice choice(bool is_transparent) const;

 private:
  void draw_formats(const Look& look);
  void draw_size(const Look& look);
  void draw_rate(const Animation& animation, const Look& look);
  void draw_range(const Animation& animation, const Look& look);
  void draw_tolerance(const Look& look);

  std::size_t row_ = 0;  ///< of animation_formats()
  bool has_video_ = false;
  std::optional<PictureSize> size_;
  std::optional<double> fps_;
  std::optional<std::array<int, 2>> range_;
  bool power_of_two_ = false;
  double tolerance_ = 0.5;  ///< [pixels]
};

/// Why there is no animation to be written; empty where there is one.
std::string why_no_animation(const Editor& editor);

}  // namespace foldless
