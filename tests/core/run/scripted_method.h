// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/energy/densities.h"
#include "core/method/method.h"
#include "core/run/run.h"
#include "tests/support/meshes.h"

namespace foldless::test {

/// What a ScriptedMethod does, and what it saw. Shared with the test, which may be on another
/// thread.
struct Script {
  int length = 1 << 30;  ///< iterations until the outcome `gradient`
  /// What iteration k (from 1) does to the mesh, in the normalised frame.
  std::function<void(MeshPair&, int k)> change;
  std::function<void(const Problem&)> start;  ///< called where a method starts, normalised
  /// Called before each look at the stop token: what happens in it comes before the look.
  std::function<void(const std::stop_token&)> look;
  std::string verdict;  ///< told all the time
  int stages = 1;       ///< looks at the stop token per iteration, as between factorizations
  std::chrono::microseconds stage_time{0};
  std::atomic<int> begun = 0;      ///< calls of step() that began to work
  std::atomic<int> cancelled = 0;  ///< of these, cancelled

  void saw(const Points& targets) {
    std::lock_guard lock(mutex_);
    targets_.push_back({begun, targets});
  }
  /// How many iterations had begun when the targets last equalled these; -1 when never.
  int begun_when_seen(const Points& targets) const {
    std::lock_guard lock(mutex_);
    for (auto seen = targets_.rbegin(); seen != targets_.rend(); ++seen)
      if (seen->second.cols() == targets.cols() && seen->second.isApprox(targets))
        return seen->first;
    return -1;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<int, Points>> targets_;
};

/// A method whose iterations are what a test wants them to be.
class ScriptedMethod final : public Method {
 public:
  ScriptedMethod(const Problem& problem, std::shared_ptr<Script> script)
      : problem_(problem), script_(std::move(script)) {}

  std::optional<Iteration> step(const std::stop_token& token) override {
    if (outcome()) return std::nullopt;
    ++script_->begun;
    for (int stage = 0; stage < script_->stages; ++stage) {
      if (script_->look) script_->look(token);
      if (token.stop_requested()) {
        ++script_->cancelled;
        return std::nullopt;
      }
      std::this_thread::sleep_for(script_->stage_time);
    }
    ++done_;
    if (script_->change) script_->change(problem_.mesh, done_);
    Iteration iteration;
    iteration.inner = done_;
    return iteration;
  }

  std::optional<Outcome> outcome() const override {
    if (done_ >= script_->length) return Outcome::gradient;
    return std::nullopt;
  }
  std::string verdict() const override { return script_->verdict; }
  const MeshPair& mesh() const override { return problem_.mesh; }
  void set_targets(const Points& targets) override {
    script_->saw(targets);
    done_ = 0;
  }

 private:
  Problem problem_;
  std::shared_ptr<Script> script_;
  int done_ = 0;
};

inline MethodStarter starter_of(const std::shared_ptr<Script>& script) {
  return [script](const Problem& problem) {
    if (script->start) script->start(problem);
    return std::make_unique<ScriptedMethod>(problem, script);
  };
}

/// The grid of n × n vertices, its lower left corner pinned and its upper right one to be dragged
/// to `target`. The corners of square_grid(2 or 3) have a power of two for a normalised frame.
inline Problem grid_problem(int n, const Vec2& target) {
  const Fixture grid = square_grid(n);
  Problem problem;
  problem.mesh = MeshPair(grid.triangles, grid.rest);
  problem.energy = find_density("dirichlet");
  problem.handles = {{.id = 1, .vertex = 0, .target = grid.rest.col(0)},
                     {.id = 2, .vertex = n * n - 1, .target = target}};
  return problem;
}

/// Moves the vertex by `offset`; a fold when it is far enough.
inline void displace(MeshPair& mesh, int vertex, const Vec2& offset) {
  Points deformed = mesh.deformed();
  deformed.col(vertex) += offset;
  mesh.set_deformed(std::move(deformed));
}

}  // namespace foldless::test
