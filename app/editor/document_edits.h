// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/editor/draft.h"
#include "app/editor/parameter_rows.h"

namespace foldless {

/// The edits that need no pointer; each is one undo step, and none at all where it changes nothing.
class DocumentEdits {
 public:
  /// Keeps a reference.
  explicit DocumentEdits(Draft& draft) : draft_(draft) {}

  void delete_selected();
  /// Changes the selected handles; `what` says what the solver sees of it.
  void change_selected(const std::string& label, Change what,
                       const std::function<void(Handle&)>& change);
  void reset_pose();
  void set_energy(const Density& energy);
  void set_method(std::string_view name);
  /// Clamped to the row's range; changes of one row within a second make one step.
  void set_parameter(const ParameterRow& row, double value);
  void reset_parameter(const ParameterRow& row);

 private:
  Draft& draft_;
};

}  // namespace foldless
