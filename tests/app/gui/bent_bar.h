// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/edits.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {

/// Opens a bar and bends it by the paper's method, for many iterations and energies of many digits.
/// Returns whether the solver came to an end in time.
inline bool bend_a_bar(HeadlessEditor& headless) {
  Editor& editor = headless.editor();
  editor.files().open_shape(bar(4, 1, 3), "bar");
  headless.calm_down();
  Document document = editor.document();
  document.parameters.method = "paper";
  for (const int vertex : {0, 12}) document = place_handle(document, {.vertex = vertex}).document;
  document = with_targets(document, {{1, Vec2(2, 2.5)}});
  editor.draft().begin_edit();
  editor.draft().apply(document, Change::mesh);
  editor.draft().commit("Bend");
  const bool has_ended = headless.wait_until([&] { return !editor.playback().is_solving(); });
  headless.calm_down();
  return has_ended;
}

}  // namespace foldless::test
