// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "core/run/frames.h"

namespace foldless {

/// Frames that were solved before, by what they followed from. A frame depends on that alone, so
/// one that follows from the same again, bit for bit, need not be solved. Those that were added
/// first go where all would take too much memory.
class SolvedBefore {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

  explicit SolvedBefore(std::size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

  /// `frame` was solved from `before`, or from the mesh at rest when that is null, for the handles.
  void add(const std::shared_ptr<const Snapshot>& before, std::vector<Handle> handles,
           const SolvedFrame& frame);
  /// Null where there is none. Valid until the next is added.
  const SolvedFrame* find(double moment, const Snapshot* before,
                          const std::vector<Handle>& handles) const;

 private:
  struct Entry {
    std::shared_ptr<const Snapshot> before;
    std::vector<Handle> handles;
    SolvedFrame frame;
    std::size_t bytes = 0;
  };

  void remove_first();

  std::size_t most_bytes_, bytes_ = 0;
  std::map<double, std::deque<Entry>> entries_;  ///< by moment, the latest last
  std::deque<double> added_;                     ///< the moments of all, the latest last
};

}  // namespace foldless
