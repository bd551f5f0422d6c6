// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/handle_view.h"

#include "app/editor/draft.h"

namespace foldless {

std::vector<HandleView> handle_views(const Draft& draft) {
  std::vector<HandleView> views;
  if (!draft.shown()) return views;
  const Selection& selection = draft.selection();
  const double tolerance = draft.target_tolerance();
  for (const Handle& handle : draft.shown()->handles) {
    HandleView view{handle.id, handle.vertex, handle.kind, handle.name};
    view.position = draft.shown()->deformed.col(handle.vertex);
    view.target = handle.target;
    view.residual = (view.target - view.position).norm();
    view.is_at_target = view.residual <= tolerance;
    view.is_selected = selection.ids().contains(handle.id);
    view.is_hovered = selection.hovered() == handle.id;
    views.push_back(view);
  }
  return views;
}

std::string handle_title(const std::string& name, int vertex) {
  return name.empty() ? "Vertex " + std::to_string(vertex) : name;
}

}  // namespace foldless
