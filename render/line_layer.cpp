// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/line_layer.h"

namespace foldless {

LineLayer::LineLayer(const std::filesystem::path& shader_folder)
    : program_({"line"}, shader_folder) {}

void LineLayer::begin(const Frame& frame, const LineStyle& style) const {
  use_in_frame(program_, frame);
  program_.set("half_width", 0.5F * style.width * frame.ui_scale);
  program_.set("dash_length", style.dash * frame.ui_scale);
  program_.set("is_round", style.has_round_ends ? 1 : 0);
  program_.set("colour", style.colour);
}

}  // namespace foldless
