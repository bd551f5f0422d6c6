// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "core/method/stepped_method.h"

namespace foldless::test {

/// What the steps of a test do and say.
struct Script {
  std::vector<std::string> said;
  int made = 0;             ///< updates
  int cancelled = 0;        ///< times that an update was
  int cancels = 0;          ///< so many updates from now on are cancelled
  bool fails = false;       ///< the next update throws
  double* stage = nullptr;  ///< that updates are timed as, where a test does so
  std::stop_source stop;
  int stops_at = 0;  ///< the update of this number requests it, as a signal that comes meanwhile

  /// An update that is cancelled, or throws, or counts.
  VertexUpdate update() {
    if (fails) {
      fails = false;
      throw std::runtime_error("update");
    }
    if (cancels > 0) {
      --cancels;
      ++cancelled;
      return {.cancelled = true};
    }
    if (++made == stops_at) stop.request_stop();
    return {.step_length = static_cast<double>(made)};
  }
  void say(std::string words) { said.push_back(std::move(words)); }
};

/// Says so when it is destroyed.
class Guard {
 public:
  Guard(Script& script, std::string words) : script_(script), words_(std::move(words)) {}
  ~Guard() { script_.say(words_); }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

 private:
  Script& script_;
  std::string words_;
};

/// The record of an update.
inline Iteration record_of(const VertexUpdate& update) {
  Iteration record;
  record.step_length = update.step_length;
  return record;
}

/// A method that does what a function with a script says.
class ScriptedMethod final : public SteppedMethod {
 public:
  using Steps = foldless::Steps<Outcome>(Script& script);

  ScriptedMethod(Script& script, Steps* steps) : script_(script), steps_(steps) {
    begin(steps_(script_));
  }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points&) override { begin(steps_(script_)); }
  using SteppedMethod::effort;

 private:
  Script& script_;
  Steps* steps_;
  MeshPair mesh_;
};

}  // namespace foldless::test
