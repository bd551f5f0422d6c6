// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "render/image.h"

namespace foldless {

bool is_gif(std::string_view file);

/// The first picture of a GIF on its canvas; transparent is what it does not cover. Throws Error,
/// which names no file, where there is none, it is damaged, or too large for check_image_size().
Image decode_gif(std::string_view file);

}  // namespace foldless
