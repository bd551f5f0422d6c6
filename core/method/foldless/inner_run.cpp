// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/inner_run.h"

namespace foldless {
namespace inner_run {

struct Step {
  std::optional<Iteration> record;
  bool cancelled = false;
};
bool is_cancelled(const Step& step) { return step.cancelled; }

struct Made {
  bool cancelled = false;
};
bool is_cancelled(const Made& made) { return made.cancelled; }

}  // namespace inner_run

Steps<> run_inside(SteppedMethod& run, Phase phase, Effort& effort) {
  const Effort before = effort;
  const auto next = [&run](const std::stop_token& token) {
    const std::optional<Iteration> record = run.step(token);
    return inner_run::Step{record, !record && !run.outcome()};
  };
  while (!run.outcome()) {
    inner_run::Step step = co_await vertex_update(next);
    effort = before + run.spent();
    if (!step.record) break;
    step.record->phase = phase;
    co_yield *step.record;
  }
}

Steps<> in_phase(Phase phase, Steps<> steps) {
  StepContext own;
  steps.begin(own);
  const auto next = [&own](const std::stop_token& token) {
    return inner_run::Made{!own.request->make(token)};
  };
  while (!steps.have_ended()) {
    own.record.reset();
    co_await vertex_update(next);
    own.waiting.resume();
    if (!own.record) continue;
    own.record->phase = phase;
    co_yield *own.record;
  }
  steps.result();
}

}  // namespace foldless
