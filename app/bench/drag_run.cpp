// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/drag_run.h"

#include <algorithm>

#include "core/stage_times.h"

namespace foldless {
namespace {

constexpr int kMostIterations = 2;
constexpr double kHome = 1e-6;  ///< [D]

/// How far the farthest handle is from its target. [length]
double farthest(const Snapshot& state) {
  double distance = 0;
  for (const Handle& handle : state.handles)
    distance = std::max(distance, (state.deformed.col(handle.vertex) - handle.target).norm());
  return distance;
}

}  // namespace

void run_drag(const BenchJob& job, Run& run, const std::stop_token& token, BenchRow& row) {
  while (const auto record = run.step(token)) row.iterations.push_back(*record);
  for (const Points& targets : job.scene->targets) {
    if (token.stop_requested()) return;
    DragFrame frame;
    const int factorizations = row.iterations.empty() ? 0 : row.iterations.back().factorizations;
    const double start = thread_seconds();
    run.set_targets(targets);
    while (frame.iterations < kMostIterations && farthest(*run.snapshot()) > kHome * row.diagonal) {
      const auto record = run.step(token);
      frame.seconds = thread_seconds() - start;
      if (frame.first_seconds == 0) frame.first_seconds = frame.seconds;
      if (!record) break;
      row.iterations.push_back(*record);
      ++frame.iterations;
      frame.factorizations = record->factorizations - factorizations;
    }
    if (token.stop_requested()) return;
    frame.distance = farthest(*run.snapshot());
    frame.is_valid = run.snapshot()->is_valid();
    row.frames.push_back(frame);
  }
}

}  // namespace foldless
