// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/method/method.h"
#include "core/scene/json_node.h"

namespace foldless {

/// What a solve came to: all that its report tells. Input units.
struct Solved {
  std::string scene;  ///< path as given
  Problem problem;    ///< what was solved
  int original_faces = 0;
  std::vector<Iteration> iterations;         ///< every record
  std::shared_ptr<const Snapshot> snapshot;  ///< the last state, see Run::snapshot
  Outcome outcome = Outcome::cancelled;
  std::string verdict;  ///< of the method; may be empty
  bool satisfied = false;
  StageTimes times;
  double seconds = 0;       ///< processor time of solving
  double wall_seconds = 0;  ///< time that went by, files and pictures included
};

/// The object of report.json. Energies and the gradient are those of the last valid state, and
/// null before the first iteration; counters are those of the last iteration.
JsonNode report_of(const Solved& solved);

/// The handles of a report, as a scene file has them.
JsonNode handles_node(const std::vector<Handle>& handles);

}  // namespace foldless
