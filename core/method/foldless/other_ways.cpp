// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/other_ways.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

#include "core/construct/pinned_map.h"
#include "core/method/foldless/approach.h"

namespace foldless {
namespace trying_ways {

/// Handles of a mesh of at most so many triangles are carried in many orders; all of it takes
/// seconds then.
constexpr int kLargestInManyOrders = 5000;
constexpr int kRandomOrders = 16;
/// Handles that may be cut to in all classes of maps that are tried, for each takes the longer the
/// more there are; of more than so many there is one class.
constexpr int kHandlesOfAllClasses = 80, kMostInManyClasses = 20;
/// Of which a free boundary is cut, the quickest first. With the transports of a rival the second
/// one found more than any other.
constexpr std::array kClassesOfFreeCuts = {kClassOfShortestSlits, 4};
/// One of so many is refined when nothing else helped.
constexpr int kLargestRefined = 2000;

std::array<int, kClassesOfPinnedDisks> all_classes() {
  std::array<int, kClassesOfPinnedDisks> classes;
  std::iota(classes.begin(), classes.end(), 0);
  return classes;
}

}  // namespace trying_ways

std::vector<Way> other_ways(const MeshPair& rest, const Constraints& constraints,
                            bool with_approach) {
  using namespace trying_ways;
  const int faces = rest.face_count();
  const Points starts = handle_positions(constraints, rest.deformed());
  const Points& targets = constraints.targets;
  const std::size_t first = transport_plans(starts, targets, 0).size();
  const std::vector<TransportPlan> plans =
      transport_plans(starts, targets, faces <= kLargestInManyOrders ? kRandomOrders : 0);

  std::vector<Way> ways;
  const auto add_cuts = [&](CutBoundary boundary, std::span<const int> classes) {
    const int handles = handles_to_cut(rest, constraints, boundary);
    if (handles == 0) return;
    const int most = handles > kMostInManyClasses ? 1 : kHandlesOfAllClasses / handles;
    for (const int choice : classes.first(std::min(classes.size(), static_cast<std::size_t>(most))))
      ways.push_back({.kind = Way::Kind::cut, .boundary = boundary, .choice = choice});
  };
  add_cuts(CutBoundary::free, kClassesOfFreeCuts);
  if (with_approach) ways.push_back({.kind = Way::Kind::approach});
  for (std::size_t i = 0; i < first; ++i) ways.push_back({.plan = plans[i]});
  add_cuts(CutBoundary::held, all_classes());
  for (const bool is_refined : {false, true})
    ways.push_back({.kind = Way::Kind::onwards, .is_refined = is_refined});
  for (std::size_t i = first; i < plans.size(); ++i)
    ways.push_back({.plan = plans[i], .goes_in_rounds = true});
  if (faces <= kLargestRefined)
    for (const TransportPlan& plan : plans)
      ways.push_back({.plan = plan, .is_refined = true, .goes_in_rounds = true});
  return ways;
}

// A transport that locks nearer to the targets than anything before goes on as an approach. What
// comes after a cut of a held disk that arrives takes seconds and hardly ever arrives as well.
Steps<Progress> OtherWays::try_next(Workspace& work) {
  if (!ways_) {
    rest_ = {problem_.mesh.triangles(), problem_.mesh.rest(), problem_.at_rest()};
    ways_ = other_ways(rest_, work.constraints, with_approach_);
    locked_error_ = work.error();
  }
  const Way way = (*ways_)[next_++];
  if (way.kind == Way::Kind::onwards && !nearest_) co_return Progress::locked;
  ++work.system.effort().rounds;
  Workspace other = way.kind == Way::Kind::onwards ? *nearest_ : work;
  if (way.kind != Way::Kind::onwards) other.set_mesh(rest_);
  if (way.is_refined) other.refine();
  Progress progress = co_await go(way, other);
  const bool is_transport = way.kind == Way::Kind::transport || way.kind == Way::Kind::onwards;
  if (progress == Progress::locked && is_transport) {
    if (!nearest_ || other.error() < nearest_->error()) nearest_ = other;
    if (other.error() < locked_error_) progress = co_await approach(other, FactorUse::own);
  }
  if (progress == Progress::locked) locked_error_ = std::min(locked_error_, other.error());
  if (progress == Progress::arrived || other.error() < work.error()) work = std::move(other);
  if (progress == Progress::arrived && way.kind == Way::Kind::cut) {
    if (way.boundary == CutBoundary::held) leave_only_cuts();
    has_cut_free_ = has_cut_free_ || way.boundary == CutBoundary::free;
  }
  co_return progress;
}

void OtherWays::leave_only_cuts() {
  const auto next = ways_->begin() + static_cast<std::ptrdiff_t>(next_);
  const auto left =
      std::remove_if(next, ways_->end(), [](const Way& way) { return way.kind != Way::Kind::cut; });
  ways_->erase(left, ways_->end());
}

Steps<Progress> OtherWays::go(const Way& way, Workspace& work) {
  if (way.kind == Way::Kind::approach) return approach(work, FactorUse::own);
  if (way.kind == Way::Kind::onwards) return transport_onwards(work);
  if (way.kind == Way::Kind::cut) return cut_to_handles(work, way.boundary, way.choice);
  return way.goes_in_rounds ? transport_in_rounds(work, way.plan) : transport(work, way.plan);
}

}  // namespace foldless
