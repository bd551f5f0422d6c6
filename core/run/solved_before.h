// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "core/run/frames.h"

namespace foldless {

/// Frames that were solved before, by what they followed from. A frame depends on that alone, so
/// one that follows from the same again, bit for bit, need not be solved. Of each moment the latest
/// few are kept.
class SolvedBefore {
 public:
  /// `frame` was solved from `before`, or from the mesh at rest when that is null, for the handles.
  void add(const std::shared_ptr<const Snapshot>& before, std::vector<Handle> handles,
           const SolvedFrame& frame);
  /// Null where there is none.
  const SolvedFrame* find(double moment, const Snapshot* before,
                          const std::vector<Handle>& handles) const;

 private:
  struct Entry {
    std::shared_ptr<const Snapshot> before;
    std::vector<Handle> handles;
    SolvedFrame frame;
  };
  std::map<double, std::deque<Entry>> entries_;  ///< by moment, the latest last
};

}  // namespace foldless
