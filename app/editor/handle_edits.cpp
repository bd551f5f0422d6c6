// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/handle_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/mirroring.h"

namespace foldless {
namespace {

constexpr double kMostDepth = 1000;
constexpr double kStiffReach = 0.1;  // of the diagonal
constexpr double kLeastWeight = 1e-3, kMostWeight = 1e3;

/// What all agree in: nothing as soon as one differs.
template <class Value>
void agree(std::optional<Value>& common, const Value& value, bool is_first) {
  if (is_first)
    common = value;
  else if (common != value)
    common.reset();
}

void shift_depth(Editor& editor, const char* label, double by) {
  editor.edits().change_selected(label, Change::appearance, [by](Handle& handle) {
    handle.depth = std::clamp(handle.depth + by, -kMostDepth, kMostDepth);
  });
}

/// As they are on screen, where an earlier iteration or a frame may be looked at.
const std::vector<Handle>& shown_handles(const Editor& editor) {
  return editor.shown() ? editor.shown()->handles : editor.document().handles;
}

double nudge_length(const Editor& editor) {
  const Canvas& canvas = editor.canvas();
  const Modifiers& modifiers = editor.input().modifiers();
  const double steps = modifiers.shift ? 10 : modifiers.alt ? 0.1 : 1;
  if (editor.document().texture_box) return steps;  // the unit of length is its pixel
  return steps * canvas.ui_scale / canvas.camera.pixels_per_unit;
}

}  // namespace

SelectedHandles selected_handles(const Editor& editor) {
  SelectedHandles selected;
  for (const Handle& handle : shown_handles(editor)) {
    if (!editor.selection().ids().contains(handle.id)) continue;
    const bool is_first = !std::exchange(selected.are_there, true);
    agree(selected.kind, handle.kind, is_first);
    agree(selected.weight, handle.weight, is_first);
    agree(selected.depth, handle.depth, is_first);
    agree(selected.name, handle.name, is_first);
    agree(selected.x, handle.target.x(), is_first);
    agree(selected.y, handle.target.y(), is_first);
    agree(selected.turns, handle.turn.has_value(), is_first);
    agree(selected.angle, handle.turn.value_or(Turn{}).angle, is_first);
    const StiffDisk stiff = handle.stiff.value_or(StiffDisk{});
    agree(selected.stiffness, stiff.factor, is_first);
    agree(selected.stiff_radius, stiff.radius, is_first);
    agree(selected.radius, handle.turn.value_or(Turn{}).radius, is_first);
  }
  return selected;
}

std::vector<Target> selected_targets(const Editor& editor) {
  std::vector<Target> targets;
  for (const Handle& handle : shown_handles(editor)) {
    if (!editor.selection().ids().contains(handle.id)) continue;
    targets.push_back({handle.id, handle.target});
    if (handle.turn) targets.back().angle = handle.turn->angle;
  }
  return targets;
}

void set_kind(Editor& editor, HandleKind kind) {
  editor.edits().change_selected("Kind of handle", Change::mesh,
                                 [kind](Handle& handle) { handle.kind = kind; });
}

void toggle_pin(Editor& editor) {
  editor.edits().change_selected("Pin or drag", Change::mesh, [](Handle& handle) {
    handle.kind = handle.kind == HandleKind::pin ? HandleKind::drag : HandleKind::pin;
  });
}

void set_weight(Editor& editor, double weight) {
  if (!std::isfinite(weight)) return;
  weight = std::clamp(weight, kLeastWeight, kMostWeight);
  editor.edits().change_selected("Weight", Change::mesh,
                                 [weight](Handle& handle) { handle.weight = weight; });
}

void set_depth(Editor& editor, double depth) {
  if (!std::isfinite(depth)) return;
  depth = std::clamp(depth, -kMostDepth, kMostDepth);
  editor.edits().change_selected("Depth", Change::appearance,
                                 [depth](Handle& handle) { handle.depth = depth; });
}

void set_name(Editor& editor, const std::string& name) {
  editor.edits().change_selected("Name", Change::appearance,
                                 [&](Handle& handle) { handle.name = name; });
}

void set_coordinate(Editor& editor, int axis, double value) {
  if (!std::isfinite(value)) return;
  editor.draft().interrupt();
  std::vector<Target> targets = selected_targets(editor);
  const auto is_there = [&](const Target& target) { return target.position[axis] == value; };
  if (std::ranges::all_of(targets, is_there)) return;
  for (Target& target : targets) target.position[axis] = value;
  editor.playback().use_iteration();  // what is looked at is what is moved
  editor.draft().solving().clear_timeline();
  editor.draft().edit(
      "Move handles",
      with_targets(editor.document(), with_rig(editor, editor.document(), std::move(targets))),
      Change::targets);
}

void set_stiffness(Editor& editor, double factor) {
  if (!std::isfinite(factor)) return;
  factor = std::clamp(factor, StiffnessBrush::kLeastFactor, StiffnessBrush::kLargestFactor);
  if (editor.document().is_empty()) return;
  const Points& rest = editor.document().original->rest;
  const double diagonal = (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm();
  editor.edits().change_selected("Stiffness of handle", Change::mesh, [=](Handle& handle) {
    const double radius = handle.stiff ? handle.stiff->radius : kStiffReach * diagonal;
    handle.stiff.reset();
    if (factor != 1) handle.stiff = StiffDisk{factor, radius};
  });
}

void set_stiff_radius(Editor& editor, double radius) {
  if (!std::isfinite(radius) || radius <= 0) return;
  editor.edits().change_selected("Stiff radius", Change::mesh, [radius](Handle& handle) {
    if (handle.stiff) handle.stiff->radius = radius;
  });
}

void bring_forward(Editor& editor) { shift_depth(editor, "Bring forward", 1); }
void send_back(Editor& editor) { shift_depth(editor, "Send back", -1); }

void nudge(Editor& editor, const Vec2& direction) {
  editor.draft().interrupt();
  if (editor.selection().ids().empty()) return;
  editor.playback().use_iteration();  // what is looked at is what is nudged
  std::vector<Target> targets = selected_targets(editor);
  for (Target& target : targets) target.position += nudge_length(editor) * direction;
  editor.draft().solving().clear_timeline();
  targets = with_rig(editor, editor.document(), std::move(targets));
  editor.draft().edit_again("Nudge", with_targets(editor.document(), targets), Change::targets);
}

}  // namespace foldless
