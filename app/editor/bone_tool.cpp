// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/bone_tool.h"

#include <algorithm>

#include "app/editor/bones.h"
#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

/// The bones that end in a joint, or that joint alone.
Bones chain_to(const Document& document, int joint) {
  for (const Bones& bones : document.rig.bones)
    if (bones.back() == joint) return bones;
  return {joint};
}

}  // namespace

void BoneTool::toggle() {
  is_on_ = !is_on_;
  end_chain();
}

Bones BoneTool::chain() const {
  const Document& document = draft_.document();
  if (original_ != document.original) return {};
  Bones chain = chain_;
  // Bones are undone from their end.
  while (chain.size() > 1 && chain_to(document, chain.back()) != chain) chain.pop_back();
  if (chain.size() == 1 && !find_handle(document, chain.front())) chain.clear();
  return chain;
}

void BoneTool::click(Editor& editor, const Vec2& pixel) {
  chain_ = chain();
  original_ = draft_.document().original;
  Draft& draft = editor.draft();
  const Snapshot* shown = editor.shown().get();
  const auto handle = pick_handle(shown, editor.canvas(), pixel);
  if (handle && !chain_.empty() && handle->id == chain_.back()) return end_chain();
  const auto place = pick_mesh(shown, editor.canvas(), pixel, draft.paint_order());
  if (!handle && !place) return;
  draft.begin_edit();
  const bool is_new = !handle && place_at(editor, *place);
  const int joint = handle ? handle->id : editor.selection().order().front();
  const bool adds = add(joint, draft);
  editor.selection().select({joint});
  if (is_new || adds)
    draft.commit(adds ? "Draw bones" : "Place handle");
  else
    draft.abandon_edit();
}

bool BoneTool::add(int joint, Draft& draft) {
  if (chain_.empty()) {
    chain_ = chain_to(draft_.document(), joint);
    return false;
  }
  if (std::ranges::find(chain_, joint) != chain_.end()) return false;
  chain_.push_back(joint);
  draft.apply(with_bones_through(draft_.document(), chain_), Change::appearance);
  return true;
}

}  // namespace foldless
