// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/selection.h"

#include <algorithm>
#include <utility>

namespace foldless {

void Selection::select(std::set<int> ids) {
  if (ids == ids_) return;
  ids_ = std::move(ids);
  prune();
  messages_.redraw();
}

void Selection::select_all() {
  std::set<int> ids;
  for (const Handle& handle : document_.handles) ids.insert(handle.id);
  select(std::move(ids));
}

void Selection::invert() {
  std::set<int> ids;
  for (const Handle& handle : document_.handles)
    if (!ids_.contains(handle.id)) ids.insert(handle.id);
  select(std::move(ids));
}

void Selection::hover(std::optional<int> id) {
  if (std::exchange(hovered_, id) != id) messages_.redraw();
}

void Selection::prune() {
  std::erase_if(ids_, [this](int id) { return !find_handle(document_, id); });
  std::erase_if(order_, [this](int id) { return !ids_.contains(id); });
  for (const int id : ids_)
    if (std::find(order_.begin(), order_.end(), id) == order_.end()) order_.push_back(id);
  if (hovered_ && !find_handle(document_, *hovered_)) hovered_.reset();
}

}  // namespace foldless
