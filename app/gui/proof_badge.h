// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/editor/motion_bake.h"
#include "app/editor/proof.h"
#include "app/gui/look.h"

namespace foldless {

/// The badge in words that take at most `room` pixels in the current font; the shortest words
/// where none fit.
std::string badge_words(const Proof& proof, float room);

/// What the badge says of a whole animation, in words that take at most `room` pixels in the
/// current font, the shortest where none fit; empty while it has nothing to say.
std::string motion_badge_words(const MotionProofStatus& motion, float room);

/// Always in sight: whether the map on screen is proved to be without fold, at the right end of
/// the current window and at most `room` pixels wide. Yellow with words when the map folds. Of an
/// animation it says whether it is so at every moment, unless the map on screen is not.
void draw_proof_badge(const Proof& proof, const MotionProofStatus& motion, float room,
                      const Look& look);

}  // namespace foldless
