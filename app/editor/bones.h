// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/edits.h"

namespace foldless {

class Editor;

/// Targets of handles that are moved, and of the other joints of their bones: they keep the lengths
/// that they have at rest, see with_moved_joints(). A joint that turns the mesh turns with the bone
/// that ends in it. `before`: as it was when the hand began to move them.
std::vector<Target> with_bones(const Document& before, std::vector<Target> moved);

/// Bones whose joints are all there: a chain that lost some goes on from one that is left to the
/// next, and one without two is gone.
std::vector<Bones> bones_of(std::vector<Bones> bones, const std::vector<Handle>& handles);

/// The document with a chain, root first, whose joints leave those that they were in.
Document with_bones_through(Document document, const Bones& chain);

// Commands; each is one undo step.

/// A chain through the selected handles in the order of their selection, root first. They leave the
/// chains that they were in; the end of the new one stays selected.
void make_bones(Editor& editor);
bool can_make_bones(const Editor& editor);
/// Of all chains that have a selected joint.
void take_bones_apart(Editor& editor);
bool can_take_bones_apart(const Editor& editor);

}  // namespace foldless
