// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/document_edits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/editor/edits.h"
#include "core/method/methods.h"

namespace foldless {

void DocumentEdits::delete_selected() {
  draft_.interrupt();
  const std::set<int> selected = draft_.selection().ids();
  if (selected.empty()) return;
  draft_.begin_edit();
  draft_.apply(without_handles(draft_.document(), selected), Change::mesh);
  draft_.commit(selected.size() == 1 ? "Delete handle" : "Delete handles");
}

void DocumentEdits::change_selected(const std::string& label, Change what,
                                    const std::function<void(Handle&)>& change) {
  draft_.interrupt();
  const auto changed = [&](std::vector<Handle> handles) {
    for (Handle& handle : handles)
      if (draft_.selection().ids().contains(handle.id)) change(handle);
    return handles;
  };
  if (changed(draft_.document().handles) == draft_.document().handles) return;
  draft_.begin_edit();
  Document document = draft_.document();  // with the handles of the iteration that is shown, if any
  document.handles = changed(std::move(document.handles));
  if (what == Change::targets) draft_.solving().clear_timeline();
  draft_.apply(std::move(document), what);
  draft_.commit(label);
}

void DocumentEdits::reset_pose() {
  draft_.interrupt();
  if (draft_.document().is_empty()) return;
  draft_.begin_edit();
  draft_.apply(in_rest_pose(draft_.document()), Change::mesh);
  draft_.commit("Reset pose");
}

void DocumentEdits::set_energy(const Density& energy) {
  draft_.interrupt();
  Document document = draft_.document();
  if (document.energy == &energy) return;
  document.energy = &energy;
  draft_.edit("Energy: " + std::string(energy.title), std::move(document), Change::parameters);
}

void DocumentEdits::set_method(std::string_view name) {
  draft_.interrupt();
  Document document = draft_.document();
  const MethodRow* method = find_method(name);
  if (!method || document.parameters.method == name) return;
  document.parameters.method = name;
  draft_.edit("Method: " + std::string(method->title), std::move(document), Change::parameters);
}

void DocumentEdits::set_parameter(const ParameterRow& row, double value) {
  draft_.interrupt();
  if (!std::isfinite(value)) return;
  value = std::clamp(value, row.minimum, row.maximum);
  Document document = draft_.document();
  if (row.get(document.parameters, *document.energy) == value) return;
  row.set(document.parameters, value);
  draft_.edit_again(std::string(row.title), std::move(document), Change::parameters);
}

void DocumentEdits::reset_parameter(const ParameterRow& row) {
  draft_.interrupt();
  Document document = draft_.document();
  if (!is_changed(row, document.parameters, *document.energy)) return;
  row.reset(document.parameters);
  draft_.edit("Reset " + std::string(row.title), std::move(document), Change::parameters);
}

}  // namespace foldless
