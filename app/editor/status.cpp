// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/status.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "app/editor/draft.h"
#include "app/editor/handle_view.h"
#include "app/editor/motion.h"
#include "core/method/map_words.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

/// What `foldless` does where handles are locked, while the best mesh stays on show.
std::string locked_words(const Iteration& last) {
  if (last.phase == Phase::transport) return ": handles are locked, trying a way round";
  if (last.phase == Phase::whitened)
    return ": handles are locked, trying a rounder picture of the mesh";
  if (last.phase == Phase::approach && last.outer > 0)
    return ": handles are locked, edges were split";
  return {};
}

std::string solving_words(const Draft& draft) {
  const Parameters& parameters = draft.document().parameters;
  std::string words = "Solving";
  if (draft.solving().iterations().empty()) return words;
  const Iteration& last = draft.solving().iterations().back();
  if (const std::string locked = locked_words(last); !locked.empty()) return words + locked;
  if (last.phase == Phase::anew || last.phase == Phase::walk)
    return words + ": on target, looking for a better shape";
  if (last.phase == Phase::coarse) words.append(" on a coarser mesh first");
  const MethodRow* method = find_method(parameters.method);
  if (method && !reads(*method, "inner_iterations"))
    return words.append(", step ").append(std::to_string(last.inner));
  words.append(" ").append(std::to_string(last.inner));
  words.append("/").append(std::to_string(parameters.inner_iterations));
  if (last.outer > 0) {
    words.append(", round ").append(std::to_string(last.outer + 1));
    words.append("/").append(std::to_string(parameters.outer_iterations));
  }
  return words;
}

std::string capitalised(std::string words) {
  if (!words.empty() && 'a' <= words[0] && words[0] <= 'z') words[0] += 'A' - 'a';
  return words;
}

/// What is wrong with a map of a method that may fold, before other words unless they say so.
std::string marked(const Snapshot& shown, const std::string& words) {
  InjectivityReport report;
  report.inverted = shown.folded_triangles;
  report.branch_vertices = shown.branch_vertices;
  const std::string what = capitalised(words_on(report));
  if (what.empty() || words.find(what.substr(1)) != std::string::npos) return words;
  return what + ". " + words;
}

/// What is proved of all frames, and of the moments between them.
std::string whole_words(const FramesStatus& frames, const MotionProofStatus& proof) {
  using State = MotionProofStatus::State;
  if (frames.round > 1) return "the loop did not close: solving it once more";
  const bool has_all = frames.injective == frames.count;
  if (has_all && proof.state == State::proved)
    return "every moment of the animation proved injective";
  std::string all = std::to_string(frames.injective) + " of " + std::to_string(frames.count) +
                    " frames proved injective";
  if (proof.state == State::running) return all + ", proving the moments between";
  if (proof.state == State::unproved) return all + ", not between: " + proof.problem;
  return all;
}

/// How far a loop that does not close is from its first shape.
std::string gap_words(const Motion& motion) {
  const std::optional<double> gap = motion.gap();
  if (!gap) return {};
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " · the loop comes back only to within %.3g px", *gap);
  return text.data();
}

/// How a run that has ended by itself, or a restored document, stands.
Status ended(const Document& document) {
  const std::string& verdict = document.standing.verdict;
  if (!verdict.empty()) return {StatusKind::blocked, capitalised(verdict)};
  if (is_at_targets(document)) return {StatusKind::converged, "Converged"};
  if (!document.standing.outcome || document.standing.outcome == Outcome::cancelled)
    return {StatusKind::stopped, "Stopped"};
  if (document.standing.outcome == Outcome::iteration_limit)
    return {StatusKind::blocked, "Blocked: out of iterations before the handles got there"};
  return {StatusKind::blocked, "Blocked: some handles cannot get to their targets"};
}

/// A pause hides nothing: a run that has come to its end while paused still says how.
Status paused(const Document& document, const Solving& solving) {
  if (!solving.has_ended() && !is_at_targets(document)) return {StatusKind::paused, "Paused"};
  Status status = ended(document);
  status.words += " (paused)";
  return status;
}

Status in_words(const Draft& draft) {
  const Document& document = draft.document();
  const Solving& solving = draft.solving();
  if (document.is_empty()) return {StatusKind::empty, "Nothing is open"};
  if (document.handles.empty()) return {StatusKind::ready, "Ready"};
  if (!solving.error().empty() && solving.state() != SolvingState::held)
    return {StatusKind::failed, solving.error()};
  switch (solving.state()) {
    case SolvingState::running: return {StatusKind::solving, solving_words(draft)};
    case SolvingState::paused: return paused(document, solving);
    case SolvingState::stopped: return {StatusKind::stopped, "Stopped"};
    case SolvingState::held:
    case SolvingState::finished: break;
  }
  return ended(document);
}

}  // namespace

Status status_of(const Draft& draft) {
  Status status = in_words(draft);
  if (draft.shown()) status.words = marked(*draft.shown(), status.words);
  for (const HandleView& handle : handle_views(draft))
    status.residual = std::max(status.residual, handle.residual);
  return status;
}

Status status_of(const Motion& motion) {
  const FramesStatus frames = motion.frames().status();
  const std::string frame = "Frame " + moment_words(motion.play_head().moment());
  if (!frames.error.empty()) return {StatusKind::failed, frames.error};
  const auto solved = motion.solved();
  if (!solved)
    return {StatusKind::solving, frame + " is not solved yet: " + std::to_string(frames.solved) +
                                     " of " + std::to_string(frames.count) + " are"};
  const std::string all = gap_words(motion) + " · " + whole_words(frames, motion.proof());
  if (solved->is_satisfied) return {StatusKind::converged, frame + ": every handle is there" + all};
  const std::string why = solved->verdict.empty() ? "" : ": " + solved->verdict;
  return {StatusKind::blocked, frame + ": some handles are not at their targets" + why + all};
}

}  // namespace foldless
