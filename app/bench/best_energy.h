// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>

#include "app/bench/bench_run.h"

namespace foldless {

/// The least E_d with which any of some runs reached each scene by a locally injective map. One
/// that lies over itself at the boundary does not count: it has less to pay.
class BestEnergies {
 public:
  explicit BestEnergies(std::span<const BenchRow> rows);

  /// E_d of a run of the rows over that, at least 1; not a number where the run does not count,
  /// infinite where only another ended at zero.
  double ratio(const BenchRow& row) const;

 private:
  std::map<std::string, double> best_;  ///< by scene
};

}  // namespace foldless
