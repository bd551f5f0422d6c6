// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/editor/editor.h"
#include "app/gui/layout.h"
#include "app/gui/panels.h"

namespace foldless {

/// How an image becomes a mesh, at the right of its preview. Enter takes it, Esc leaves everything
/// as it was.
void draw_image_dialog(Editor& editor, const PanelContext& context);

/// The part of the canvas that the dialog leaves free.
Rectangle image_preview_place(const Layout& layout, float scale);

/// "2,134 triangles", or what is being done instead.
std::string import_words(const ImageImport& import);

}  // namespace foldless
