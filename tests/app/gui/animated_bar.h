// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/edits.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {

/// Opens a bar with two handles, of which the second has keys at frames 0, 10 and 20 of 25, with
/// the time line open and all frames solved.
inline void open_animated_bar(HeadlessEditor& headless) {
  Editor& editor = headless.editor();
  editor.files().open_shape(bar(4, 1, 3), "bar");
  headless.calm_down();
  Document document = editor.document();
  for (const int vertex : {0, 12}) document = place_handle(document, {.vertex = vertex}).document;
  Animation animation;
  animation.cycle = {25, false};
  HandleTracks tracks;
  tracks.handle = 1;
  const Vec2 p = document.handles[1].target;
  tracks.position = {{0, p, {}}, {10, p + Vec2(0, 1), {}}, {20, p + Vec2(-0.5, 1), {}}};
  animation.tracks = {tracks};
  document.animation = std::make_shared<const Animation>(animation);
  editor.draft().edit("Keys", document, Change::mesh);
  headless.settle();
  headless.key(Key::t);
  headless.wait_until([&] { return editor.motion().frames().status().is_done; });
  headless.settle();
}

}  // namespace foldless::test
