// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/editor/edits.h"

namespace foldless {

class Editor;

/// The handle whose place at rest is nearest to the mirror image of another's, within a distance:
/// that one itself where it lies on the axis. None without a mirror.
std::optional<int> partner_of(const Document& document, const Handle& handle, double reach);
/// Handles are partners within the hit radius, and within a fiftieth of the drawing. [length]
double partner_reach(const Editor& editor);

/// Targets that are moved, what their bones move, and while the mirror is on those of their
/// partners, which go the mirrored way. `before`: as it was when the hand began to move them.
std::vector<Target> with_rig(const Editor& editor, const Document& before,
                             std::vector<Target> moved);

/// The document with a handle at the mirror image of another's place, where the mirror is on, the
/// image on the mesh, and no handle there yet.
struct MirrorImage {
  Document document;
  bool is_beside_mesh = false;
};
MirrorImage with_mirror_image(const Editor& editor, Document document, int id);

// Commands; each is one undo step.

/// The first time the axis is found from the drawing.
void toggle_mirror(Editor& editor);
bool is_mirror_on(const Editor& editor);
void find_mirror_axis(Editor& editor);
void set_upright_mirror(Editor& editor);
void set_level_mirror(Editor& editor);
/// Every selected handle goes as far from its place at rest as its partner does, mirrored. Those
/// without a partner stay, and are said.
void pose_mirrored(Editor& editor);

}  // namespace foldless
