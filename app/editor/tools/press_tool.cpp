// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/mirroring.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"
#include "app/editor/turning.h"

namespace foldless {
namespace {

class PressTool final : public Tool {
 public:
  PressTool(const PointerPressed& event, const std::optional<HandleHit>& handle, bool is_on_mesh)
      : event_(event), handle_(handle), is_on_mesh_(is_on_mesh) {}

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    if ((event.position - event_.position).norm() <= editor.canvas().drag_threshold())
      return nullptr;
    auto next = begin_drag(editor);
    next->move(editor, event);
    return next;
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (event.button != event_.button) return nullptr;
    click(editor);
    return make_idle_tool();
  }

 private:
  bool adds() const { return event_.modifiers.shift; }
  bool subtracts() const { return event_.modifiers.control; }

  void click(Editor& editor) {
    std::set<int> selection = editor.selection().ids();
    if (handle_ && adds()) {
      if (selection.erase(handle_->id) == 0) selection.insert(handle_->id);
      editor.selection().select(std::move(selection));
    } else if (handle_ && subtracts()) {
      selection.erase(handle_->id);
      editor.selection().select(std::move(selection));
    } else if (handle_) {
      editor.selection().select({handle_->id});
    } else if (!adds() && !subtracts()) {
      click_on_bare_mesh(editor);
    }
  }

  std::optional<MeshHit> mesh_under_press(Editor& editor) const {
    return pick_mesh(editor.shown().get(), editor.canvas(), event_.position,
                     editor.draft().paint_order());
  }

  void click_on_bare_mesh(Editor& editor) {
    const auto hit = mesh_under_press(editor);
    if (!is_on_mesh_ || !hit) return editor.selection().select({});
    editor.draft().begin_edit();
    if (place_at(editor, *hit))
      editor.draft().commit("Place handle");
    else
      editor.draft().abandon_edit();
  }

  std::unique_ptr<Tool> begin_drag(Editor& editor) {
    if (handle_ && find_handle(editor.document(), handle_->id)) return drag_handle(editor);
    const auto ring = handle_ring(editor);
    if (ring && ring->is_near(event_.position, editor.canvas()) && !adds() && !subtracts())
      return begin_ring(editor, event_.position);
    const auto hit = mesh_under_press(editor);
    if (is_on_mesh_ && hit && !adds() && !subtracts()) return place_and_drag(editor, *hit);
    return make_band_tool(event_.position, band_mode(event_.modifiers));
  }

  std::unique_ptr<Tool> drag_handle(Editor& editor) {
    if (!editor.selection().ids().contains(handle_->id)) {
      std::set<int> selection = editor.selection().ids();
      if (!adds()) selection.clear();
      selection.insert(handle_->id);
      editor.selection().select(std::move(selection));
    }
    editor.draft().begin_edit();
    return drag_selection(editor,
                          editor.selection().ids().size() == 1 ? "Move handle" : "Move handles");
  }

  std::unique_ptr<Tool> place_and_drag(Editor& editor, const MeshHit& hit) {
    editor.draft().begin_edit();
    const bool is_new = place_at(editor, hit);
    return drag_selection(editor, is_new ? "Place and move handle" : "Move handle");
  }

  /// A handle that was caught at its dot follows from there, all others from their targets.
  std::unique_ptr<Tool> drag_selection(Editor& editor, std::string label) {
    editor.draft().solving().clear_timeline();
    const Document& document = editor.document();
    HandleDrag drag{editor.canvas().to_world(event_.position), {}, std::move(label), document};
    for (const int id : editor.selection().ids()) {
      const Handle& handle = *find_handle(document, id);
      const bool from_dot = handle_ && handle_->id == id && !handle_->is_target;
      drag.starts.push_back({id, from_dot ? position_of(document, handle) : handle.target});
    }
    return make_drag_tool(std::move(drag));
  }

  PointerPressed event_;
  std::optional<HandleHit> handle_;
  bool is_on_mesh_;
};

}  // namespace

bool place_at(Editor& editor, const MeshHit& hit) {
  Placed placed = place_handle(editor.document(), hit);
  if (placed.is_new) {
    MirrorImage both = with_mirror_image(editor, std::move(placed.document), placed.id);
    if (both.is_beside_mesh)
      editor.messages().toast(ToastKind::notice,
                              "Its mirror image would lie beside the mesh: one handle was placed");
    editor.draft().apply(std::move(both.document), Change::mesh);
  }
  editor.selection().select({placed.id});
  return placed.is_new;
}

std::unique_ptr<Tool> make_press_tool(const PointerPressed& event,
                                      const std::optional<HandleHit>& handle, bool is_on_mesh) {
  return std::make_unique<PressTool>(event, handle, is_on_mesh);
}

}  // namespace foldless
