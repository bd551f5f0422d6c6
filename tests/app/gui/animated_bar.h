// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/edits.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {

/// Opens a bar with handles at two of its corners, which move as `animate` says, with the time line
/// open and all frames solved.
inline void open_bar(HeadlessEditor& headless,
                     const std::function<Animation(std::vector<Handle>&)>& animate) {
  Editor& editor = headless.editor();
  editor.files().open_shape(bar(4, 1, 3), "bar");
  headless.calm_down();
  Document document = editor.document();
  for (const int vertex : {0, 12}) document = place_handle(document, {.vertex = vertex}).document;
  const Animation animation = animate(document.handles);
  document.animation = std::make_shared<const Animation>(animation);
  editor.draft().edit("Keys", document, Change::mesh);
  headless.settle();
  headless.key(Key::t);
  headless.wait_until([&] { return editor.motion().frames().status().is_done; });
  headless.settle();
}

/// The same, with keys of the second handle at frames 0, 10 and 20 of 25.
inline void open_animated_bar(HeadlessEditor& headless) {
  open_bar(headless, [](std::vector<Handle>& handles) {
    Animation animation;
    animation.cycle = {25, false};
    HandleTracks tracks;
    tracks.handle = 1;
    const Vec2 p = handles[1].target;
    tracks.position = {{0, p, {}}, {10, p + Vec2(0, 1), {}}, {20, p + Vec2(-0.5, 1), {}}};
    animation.tracks = {tracks};
    return animation;
  });
}

/// The same; the second handle is soft and turns, and all that can have keys has some.
inline void open_bar_with_all_tracks(HeadlessEditor& headless) {
  open_bar(headless, [](std::vector<Handle>& handles) {
    handles[1].kind = HandleKind::soft;
    handles[1].weight = 10;
    handles[1].turn = Turn{0, 0.5};
    Animation animation;
    animation.cycle = {25, false};
    HandleTracks tracks;
    tracks.handle = 1;
    const Vec2 p = handles[1].target;
    tracks.position = {{0, p, {}}, {20, p + Vec2(0, 0.5), {}}};
    tracks.angle = {{0, 0, {}}, {16, 30, {}}};
    tracks.depth = {{0, 0, {}}, {10, 2, {}}};
    tracks.weight = {{0, 10, {}}, {10, 20, {}}};
    animation.tracks = {tracks};
    return animation;
  });
}

}  // namespace foldless::test
