// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "app/cli/calls.h"
#include "app/cli/command_line.h"
#include "app/cli/problem.h"
#include "app/cli/progress_line.h"
#include "app/cli/report.h"
#include "app/cli/results.h"
#include "app/cli/scene_files.h"
#include "app/export/texture_place.h"
#include "core/energy/densities.h"
#include "core/error.h"
#include "core/exception_words.h"
#include "core/run/interrupt.h"
#include "core/run/run.h"
#include "core/run/stop_watch.h"
#include "core/scene/parameter_keys.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void apply_options(const SolveCall& call, Scene& scene) {
  if (!call.method.empty()) scene.parameters.method = call.method;
  if (!call.energy.empty()) scene.energy = find_density(call.energy);
  for (const ParameterOption& option : call.parameters)
    find_parameter_key(option.key)->set(scene.parameters, option.value);
}

std::optional<FigureOptions> figure_of(const SolveCall& call, const Scene& scene) {
  if (!call.render) return std::nullopt;
  // Read by Mesa's software renderer when its context is made.
  if (call.threads) setenv("LP_NUM_THREADS", std::to_string(*call.threads).c_str(), 1);
  FigureOptions figure;
  if (!scene.texture_path.empty())
    figure.texture = read_texture(scene.folder / scene.texture_path, scene.parts);
  figure.texture_place = texture_place(scene);
  figure.parts = scene.parts;
  return figure;
}

/// Does the task and adds its processor time to `seconds`.
template <typename Task>
auto timed(double& seconds, const Task& task) {
  const double start = thread_seconds();
  auto result = task();
  seconds += thread_seconds() - start;
  return result;
}

/// What is left of a limit; both in processor seconds.
std::optional<double> remaining(std::optional<double> limit, double spent) {
  if (limit) *limit -= spent;
  return limit;
}

/// Steps a run to its end, or until it is stopped, and writes frames on the way.
class Loop {
 public:
  Loop(const SolveCall& call, Solved& solved, Results& results)
      : call_(call), solved_(solved), results_(results), progress_(!call.quiet && !call.json) {}

  void finish(Run run, const StopWatch& watch) {
    take_frame(run.snapshot());
    while (!run.outcome()) {
      const std::optional<Iteration> record =
          timed(solved_.seconds, [&] { return run.step(watch.token()); });
      if (!record) break;
      solved_.iterations.push_back(*record);
      show(*record);
      take_frame(run.snapshot());
    }
    if (call_.frame_step && last_frame_ != run.snapshot()) results_.add_frame(*run.snapshot());
    solved_.snapshot = run.snapshot();
    solved_.outcome =
        run.outcome().value_or(watch.is_time_over() ? Outcome::time_limit : Outcome::cancelled);
    solved_.verdict = run.verdict();
    solved_.satisfied = run.is_satisfied();
    solved_.times = run.times();
  }

 private:
  /// Every mesh that was published anew, or every N-th of them.
  void take_frame(const std::shared_ptr<const Snapshot>& snapshot) {
    if (!call_.frame_step || snapshot == last_seen_) return;
    last_seen_ = snapshot;
    if (seen_++ % *call_.frame_step != 0) return;
    results_.add_frame(*snapshot);
    last_frame_ = snapshot;
  }

  const SolveCall& call_;
  Solved& solved_;
  Results& results_;
  void show(const Iteration& record) {
    if (!progress_.is_due()) return;
    std::ostringstream text;
    text << "iteration " << record.updates << ", energy " << record.energy << ", handle error "
         << std::sqrt(record.handle_error_squared);
    progress_.show(text.str());
  }

  ProgressLine progress_;
  int seen_ = 0;
  std::shared_ptr<const Snapshot> last_seen_;
  std::shared_ptr<const Snapshot> last_frame_;
};

const char* standing_of(const Solved& solved) {
  if (!solved.snapshot->is_valid()) return "the map is not locally injective";
  return solved.satisfied ? "every handle is at its target" : "handles are not all reached";
}

void print_summary(const SolveCall& call, const Solved& solved) {
  const Iteration last = solved.iterations.empty() ? Iteration{} : solved.iterations.back();
  std::cout << standing_of(solved) << " ("
            << (solved.verdict.empty() ? name_of(solved.outcome) : std::string_view(solved.verdict))
            << "): " << last.updates << " updates, " << last.factorizations << " factorizations, "
            << last.flips << " flips, " << solved.seconds << " s; written to "
            << call.folder.string() << '\n';
}

int status_of(const Solved& solved) {
  if (solved.outcome == Outcome::cancelled) return kExitInterrupted;
  const bool has_ended = solved.outcome != Outcome::time_limit;
  return solved.satisfied && has_ended ? kExitDone : kExitNotSatisfied;
}

int solve_one(const SolveCall& call) {
  const Clock::time_point start = Clock::now();
  const EndAtOnce nothing_to_keep(kExitInterrupted);
  LoadedScene loaded = load_scene_file(call.scene);
  Scene& scene = loaded.scene;
  apply_options(call, scene);
  Team team(call.threads.value_or(cores()));
  const WithTeam with(&team);
  Solved solved;
  solved.scene = call.scene.string();
  solved.problem = problem_of(scene);
  solved.original_faces = static_cast<int>(scene.triangles.cols());
  Run run = timed(solved.seconds,
                  [&] { return naming(call.scene, [&] { return Run(solved.problem); }); });
  const Interrupt interrupt;
  const StopWatch watch({.time_limit = remaining(call.time_limit, solved.seconds),
                         .is_interrupted = [&] { return interrupt.is_requested(); }});
  Results results(call.folder, call.frame_step.has_value(), figure_of(call, scene));
  if (!call.quiet) print_notices(loaded.notices);
  Loop(call, solved, results).finish(std::move(run), watch);
  solved.wall_seconds = seconds_since(start);
  const JsonNode report = report_of(solved);
  results.finish(solved, report);
  if (call.json)
    std::cout << json_text(report);
  else if (!call.quiet)
    print_summary(call, solved);
  return status_of(solved);
}

/// A call for each of the scenes that fall to the shard, into a folder of its name. Throws Error
/// where two scenes have one name.
std::vector<SolveCall> calls_of(const SolveCall& call) {
  const std::vector<std::filesystem::path> files = scene_files({call.scene});
  const Shard shard = call.shard.value_or(Shard{});
  std::map<std::string, std::filesystem::path> names;
  std::vector<SolveCall> calls;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = name_of_scene(files[i]);
    if (const auto [other, is_new] = names.emplace(name, files[i]); !is_new)
      throw Error(files[i].string() + ": would be written to the folder of " +
                  other->second.string() + ", which has the same name");
    if (!shard.holds(i)) continue;
    calls.push_back(call);
    calls.back().scene = files[i];
    calls.back().folder = call.folder / name;
  }
  return calls;
}

/// One scene after the other. One that cannot be solved is told of and keeps no other from being.
int solve_all(const std::vector<SolveCall>& calls) {
  int status = kExitDone;
  for (const SolveCall& call : calls) {
    int ended = kExitBadInput;
    std::cout.flush();  // a signal may end the next one at once
    try {
      ended = solve_one(call);
    } catch (const std::exception& error) {
      std::cerr << "foldless: " << words_of_exception(error, call.scene) << '\n';
    }
    if (ended == kExitInterrupted) return ended;
    status = std::max(status, ended);
  }
  return status;
}

}  // namespace

int solve(const SolveCall& call) {
  return are_scenes(call.scene) ? solve_all(calls_of(call)) : solve_one(call);
}

}  // namespace foldless
