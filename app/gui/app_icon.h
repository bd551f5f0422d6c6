// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/image.h"

namespace foldless {

/// The program's icon, a mesh of three triangles with a handle at its top, `side` pixels wide.
Image app_icon(int side);

}  // namespace foldless
