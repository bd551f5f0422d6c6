// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/method/method.h"

namespace foldless {

/// What the user wants of the worker.
enum class WorkerMode { idle, paused, running };

/// Messages to the worker that it has not taken up yet, the newest of each kind. They are applied
/// in the order of the members.
struct Inbox {
  struct Load {
    Load(Problem p, std::uint64_t g) : problem(std::move(p)), generation(g) {}
    Problem problem;
    std::uint64_t generation;
  };
  struct Settings {
    const Density* energy;
    Parameters parameters;
  };

  struct Targets {
    Points positions;
    std::vector<double> angles;
  };

  std::unique_ptr<const Load> load;  ///< by pointer: meshes are copied where they are moved
  std::optional<Settings> settings;
  std::optional<Targets> targets;
  std::optional<WorkerMode> mode;
  bool step = false;  ///< one iteration in spite of the mode
  std::optional<std::optional<double>> pace;

  void set_mode(WorkerMode wanted) {
    mode = wanted;
    step = false;
  }
  bool is_empty() const { return !load && !settings && !targets && !mode && !step && !pace; }
};

// Taking messages out needs no memory, so that none is lost for want of it.
static_assert(std::is_nothrow_move_constructible_v<Inbox> &&
              std::is_nothrow_move_assignable_v<Inbox>);

}  // namespace foldless
