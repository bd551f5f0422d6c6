// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/messages.h"

namespace foldless {

/// Which handles of a document are selected, and the one under the pointer.
class Selection {
 public:
  /// Keeps references.
  Selection(const Document& document, Messages& messages)
      : document_(document), messages_(messages) {}

  const std::set<int>& ids() const { return ids_; }
  /// The same in the order in which they were selected; those of one gesture by id.
  const std::vector<int>& order() const { return order_; }
  /// Ids that the document does not have are passed over.
  void select(std::set<int> ids);
  void select_all();
  void select_none() { select({}); }
  void invert();

  /// An id.
  std::optional<int> hovered() const { return hovered_; }
  void hover(std::optional<int> id);

  /// Forgets the handles that the document has no more.
  void prune();

 private:
  const Document& document_;
  Messages& messages_;
  std::set<int> ids_;
  std::vector<int> order_;
  std::optional<int> hovered_;
};

}  // namespace foldless
