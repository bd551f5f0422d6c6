// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/editor/draft.h"

namespace foldless {

class Editor;

/// Draws bones joint by joint: in the hand, every click goes on from the last one.
class BoneTool {
 public:
  /// Keeps a reference.
  explicit BoneTool(const Draft& draft) : draft_(draft) {}

  bool is_on() const { return is_on_; }
  void toggle();
  /// The joints of the chain that is drawn, root first, as far as the document still has them.
  Bones chain() const;
  /// The next click begins another chain.
  void end_chain() { chain_.clear(); }
  /// Adds the handle under a pixel of the canvas, or a new one: an undo step. The first one may be
  /// the end of bones that are there, which then go on; on the last one the chain ends.
  void click(Editor& editor, const Vec2& pixel);

 private:
  /// Goes on with a joint; returns whether the document changed.
  bool add(int joint, Draft& draft);

  const Draft& draft_;
  bool is_on_ = false;
  Bones chain_;
  std::shared_ptr<const Shape> original_;  ///< of the mesh that the chain is on
};

}  // namespace foldless
